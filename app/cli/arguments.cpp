#include "app/cli/arguments.h"

#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "app/project/file/rgb_text.h"
#include "app/project/options/settings.h"
#include "app/project/pixel_rect.h"
#include "app/project/project_fwd.h"
#include "core/energy/material.h"

namespace wend {
namespace {

bool takes(const Option& option, const std::string& command) {
    return (" " + std::string(option.commands) + " ").find(" " + command + " ") != std::string::npos;
}

const Option* findFlag(const std::string& flag, const std::string& command) {
    for (const Option& one : options())
        if (one.flag == flag && takes(one, command)) return &one;
    return nullptr;
}

constexpr std::array<std::pair<std::string_view, std::string_view>, 3> kShortFlags{
    {{"-o", "--output"}, {"-q", "--quiet"}, {"-h", "--help"}}};

std::string fullName(const std::string& word) {
    for (const auto& [brief, full] : kShortFlags)
        if (word == brief) return std::string(full);
    return word;
}

std::string shortName(std::string_view flag) {
    for (const auto& [brief, full] : kShortFlags)
        if (flag == full) return std::string(brief);
    return {};
}

std::string spaced(std::string_view choices) {
    std::string text;
    for (char c : choices) text += c == '|' ? std::string(", ") : std::string(1, c);
    return text;
}

void checkNumber(const Option& option, const std::string& value) {
    const std::string flag(option.flag);
    const auto number = finiteNumber(value);
    if (!number && option.kind == OptionKind::Unbounded)
        throw UsageError(flag + ": \"" + value + "\" is neither a number nor " + std::string(option.choices));
    if (!number) throw UsageError(flag + ": \"" + value + "\" is not a number");
    if (option.kind == OptionKind::Integer && *number != std::floor(*number))
        throw UsageError(flag + ": " + value + " is not a whole number");
    if (const std::string problem = rangeProblem(option, *number); !problem.empty())
        throw UsageError(flag + ": " + problem);
}

void check(const Option& option, const std::string& value) {
    const std::string flag(option.flag);
    if (option.kind == OptionKind::Choice && !isChoice(option, value))
        throw UsageError(flag + ": unknown value \"" + value + "\"; known are " + spaced(option.choices));
    if (option.kind == OptionKind::Canvas && !isChoice(option, value) && !pixelRectOf(value))
        throw UsageError(flag + ": \"" + value +
                         "\" is neither picture nor fit nor X,Y,WIDTH,HEIGHT in whole pixels");
    if (option.kind == OptionKind::Colour && !isChoice(option, value) && !rgbOf(value))
        throw UsageError(flag + ": \"" + value + "\" is neither a colour like #d9822b nor one of " +
                         spaced(option.choices));
    if (option.kind == OptionKind::Phi && !isChoice(option, value) && !finiteNumber(value))
        throw UsageError(flag + ": \"" + value + "\" is neither a number nor one of " +
                         spaced(option.choices));
    const bool isNumber = option.kind == OptionKind::Number || option.kind == OptionKind::Integer ||
                          (option.kind == OptionKind::Unbounded && !isChoice(option, value));
    if (isNumber) checkNumber(option, value);
    const bool isFile = option.kind == OptionKind::File || isRepeatable(option.kind);
    if (isFile && value.empty()) throw UsageError(flag + ": names no file");
}

std::string valueName(const Option& option) {
    if (option.kind == OptionKind::Flag) return "";
    if (option.kind == OptionKind::Choice) return std::string(option.choices);
    if (const std::string form = formBesideChoices(option); !form.empty())
        return std::string(option.choices) + "|" + (option.kind == OptionKind::Unbounded ? "X" : form);
    if (option.kind == OptionKind::Integer) return "N";
    if (option.kind == OptionKind::FilePair) return "IN OUT";
    return option.kind == OptionKind::File || option.kind == OptionKind::Output ? "FILE" : "X";
}

std::string remark(const Option& option) {
    std::string text;
    if (const std::string fallback = defaultText(option); !fallback.empty()) text += "default " + fallback;
    const bool numeric = option.kind == OptionKind::Number || option.kind == OptionKind::Integer;
    if (numeric) text += (text.empty() ? "" : "; ") + ("in " + option.range.text());
    if (option.kind == OptionKind::Output) text += "may be repeated";
    if (!option.unit.empty()) text += (text.empty() ? "" : "; ") + std::string(option.unit);
    return text.empty() ? "" : " (" + text + ")";
}

}  // namespace

Arguments::Arguments(const std::string& command, const std::vector<std::string>& words)
    : m_command(command), m_words(words) {
    bool onlyFiles = false;
    for (std::size_t at = 0; at < words.size(); ++at) {
        const std::string& word = words[at];
        if (onlyFiles || word == "-" || !word.starts_with('-')) {
            m_files.push_back(word);
        } else if (word == "--") {
            onlyFiles = true;
        } else if (const auto equals = word.find('='); equals != std::string::npos) {
            take(fullName(word.substr(0, equals)), word.substr(equals + 1), words, at);
        } else {
            take(fullName(word), std::nullopt, words, at);
        }
    }
}

void Arguments::take(const std::string& flag, const std::optional<std::string>& attached,
                     const std::vector<std::string>& words, std::size_t& at) {
    const Option* option = findFlag(flag, m_command);
    if (!option) throw UsageError("`wend " + m_command + "` has no option " + flag);
    if (has(flag) && !isRepeatable(option->kind)) throw UsageError(flag + " is given twice");
    if (option->kind == OptionKind::Flag) {
        if (attached) throw UsageError(flag + " takes no value");
        m_values.set(flag, "");
        return;
    }
    if (!attached && at + 1 == words.size()) throw UsageError(flag + " needs a value");
    const std::string value = attached ? *attached : words[++at];
    check(*option, value);
    m_values.add(flag, value);
    if (option->kind != OptionKind::FilePair) return;
    if (at + 1 == words.size()) throw UsageError(flag + " needs two files, IN and OUT");
    check(*option, words[++at]);
    m_values.add(flag, words[at]);
}

double Arguments::phi(const std::string& flag, int dim) const {
    const std::string value = text(flag);
    const double number = isChoice(option(flag), value) ? phiOfName(value, dim) : *finiteNumber(value);
    if (const std::string problem = phi::problem(number, dim); !problem.empty())
        throw UsageError(flag + ": " + problem);
    return number;
}

double Arguments::value(const Option& option, int dim) const {
    const std::string flag(option.flag);
    if (option.kind == OptionKind::Flag) return has(flag);
    if (option.kind == OptionKind::Phi) return phi(flag, dim);
    if (option.kind == OptionKind::Unbounded && isChoice(option, text(flag)))
        return std::numeric_limits<double>::infinity();
    return option.kind == OptionKind::Choice ? placeOf(option, text(flag)) : number(flag);
}

void takeSettings(Project& project, const Arguments& arguments) {
    for (const Option& one : options())
        if (one.field.at.set && arguments.has(std::string(one.flag)))
            one.field.at.set(project, arguments.value(one, dimensionOf(project)));
}

void requireFitting(const Project& project, const Arguments& arguments) {
    for (const Option& one : options())
        if (arguments.has(std::string(one.flag)) && !isFor(one, project))
            throw UsageError(std::string(one.flag) + " is for " + std::string(one.field.scope->words));
}

std::vector<OptionWords> optionWords(const std::string& command) {
    std::vector<OptionWords> all;
    for (const Option& one : options())
        if (!one.flag.empty() && takes(one, command))
            all.push_back({&one, shortName(one.flag), valueName(one), meaningOf(one) + remark(one)});
    return all;
}

std::string optionHelp(const std::string& command) {
    constexpr std::size_t kColumn = 38;
    std::string text;
    for (const OptionWords& one : optionWords(command)) {
        std::string left = "  " + std::string(one.option->flag) + (one.value.empty() ? "" : " ") + one.value;
        if (left.size() + 2 > kColumn)
            left += "\n" + std::string(kColumn, ' ');
        else
            left.resize(kColumn, ' ');
        text += left + one.meaning + "\n";
    }
    return text;
}

}  // namespace wend
