#include "app/project/options/options.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "app/project/options/option_values.h"
#include "app/project/project_fwd.h"
#include "core/energy/material.h"
#include "core/mesh/mesh_formats.h"

namespace wend {
namespace {

std::string end(double value) {
    if (std::isinf(value)) return value < 0 ? "−∞" : "∞";
    return shortNumber(value);
}

std::string code(std::string_view text) {
    return text.empty() ? "" : "`" + std::string(text) + "`";
}

using enum OptionKind;

std::string allowed(const Option& option) {
    if (option.kind == Flag || option.kind == File || option.kind == Text) return "";
    if (option.kind == Output) return "one or more files";
    if (option.kind == FilePair) return "one or more pairs of files";
    std::string text;
    for (char c : option.choices) text += c == '|' ? std::string(", ") : std::string(1, c);
    if (option.kind == Phi) text += ", or a number";
    if (const std::string form = formBesideChoices(option); !form.empty()) text += ", or " + form;
    if (!text.empty()) return text;
    return std::isinf(option.range.min) ? "any" : option.range.text();
}

}  // namespace

bool isRepeatable(OptionKind kind) {
    return kind == Output || kind == FilePair;
}

std::string formBesideChoices(const Option& option) {
    if (option.kind == Unbounded) return "a number in " + option.range.text();
    if (option.kind == Canvas) return "X,Y,WIDTH,HEIGHT";
    return option.kind == Colour ? "#RRGGBB" : "";
}

bool Range::contains(double value) const {
    if (std::isnan(value)) return false;
    return (openMin ? value > min : value >= min) && (openMax ? value < max : value <= max);
}

std::string Range::text() const {
    const bool openLeft = openMin || std::isinf(min), openRight = openMax || std::isinf(max);
    return (openLeft ? "]" : "[") + end(min) + ", " + end(max) + (openRight ? "[" : "]");
}

const Option& option(std::string_view keyOrFlag) {
    for (const Option& one : options())
        if (!keyOrFlag.empty() && (one.key == keyOrFlag || one.flag == keyOrFlag)) return one;
    throw std::logic_error("no such option: " + std::string(keyOrFlag));
}

double defaultOf(const Option& option) {
    return option.field.at.get ? option.field.at.get(*newProject())
                               : finiteNumber(std::string(option.fallback)).value_or(0);
}

double defaultOf(std::string_view keyOrFlag) {
    return defaultOf(option(keyOrFlag));
}

std::string defaultText(const Option& option) {
    if (!option.field.at.get) return std::string(option.fallback);
    const double value = option.field.at.get(*newProject());
    if (option.kind == Flag || (option.kind != Phi && !option.range.contains(value))) return {};
    return textOf(option, value);
}

std::string textOf(const Option& option, double value) {
    if (option.kind == Choice) return choicesOf(option).at(static_cast<std::size_t>(value));
    if (option.kind == Unbounded && std::isinf(value)) return std::string(option.choices);
    if (option.kind == Phi)
        if (const std::string name = nameOfPhi(value, 2); !name.empty()) return name;
    const std::string text = shortNumber(value), parts = shortNumber(1 / value);
    return text.size() > parts.size() + 4 ? "1/" + parts : text;
}

std::string rangeProblem(const Option& option, double value) {
    if (option.range.contains(value)) return {};
    return shortNumber(value) + " is out of range: it must be in " + option.range.text();
}

std::vector<std::string> choicesOf(const Option& option) {
    std::vector<std::string> all;
    std::string_view rest = option.choices;
    while (!rest.empty()) {
        const auto bar = rest.find('|');
        all.emplace_back(rest.substr(0, bar));
        rest = bar == std::string_view::npos ? std::string_view{} : rest.substr(bar + 1);
    }
    return all;
}

int placeOf(const Option& option, std::string_view choice) {
    const std::vector<std::string> all = choicesOf(option);
    return static_cast<int>(std::ranges::find(all, choice) - all.begin());
}

bool isChoice(const Option& option, std::string_view value) {
    return placeOf(option, value) < static_cast<int>(choicesOf(option).size());
}

double phiOfName(std::string_view name, int dim) {
    if (name == "equia") return phi::kEquia;
    if (name == "metr") return phi::kMetr;
    if (name == "akvf") return phi::kAkvf;
    if (name == "conf") return phi::conformal(dim);
    return std::numeric_limits<double>::quiet_NaN();
}

std::string nameOfPhi(double phi, int dim) {
    for (const char* name : {"equia", "metr", "akvf", "conf"})
        if (phiOfName(name, dim) == phi) return name;
    return {};
}

std::string shortNumber(double value) {
    std::array<char, 64> text;
    const auto done = std::to_chars(text.data(), text.data() + text.size(), value);
    std::string result(text.data(), done.ptr);
    for (const char* sign : {"e-0", "e+0", "e+"})  // 1e-05 → 1e-5, 1e+20 → 1e20
        if (const auto at = result.find(sign); at != std::string::npos)
            result.replace(at, std::string_view(sign).size(), sign[1] == '-' ? "e-" : "e");
    return result;
}

std::string meaningOf(const Option& option) {
    std::string text(option.meaning);
    for (const auto& [place, tetrahedra] : {std::pair{std::string("{surfaces}"), false}, {"{volumes}", true}})
        if (const auto at = text.find(place); at != std::string::npos)
            text.replace(at, place.size(), meshExtensionList(tetrahedra));
    return text;
}

std::string referencePage() {
    std::string page =
        "# Reference of the settings\n\n"
        "Written by `wend reference` from the program's own table; do not edit. Keys are those of a project "
        "file,\n"
        "options those of the command line. Numbers are read and written with a point, whatever the "
        "locale.\n\n"
        "| key | option | default | allowed | unit | meaning |\n| --- | --- | --- | --- | --- | --- |\n";
    for (const Option& one : options()) {
        std::string flag = code(one.flag);
        if (!one.commands.empty()) flag += " (" + std::string(one.commands) + ")";
        page += "| " + code(one.key) + " | " + flag + " | " + defaultText(one) + " | " + allowed(one) +
                " | " + std::string(one.unit) + " | " + meaningOf(one) + " |\n";
    }
    return page;
}

}  // namespace wend
