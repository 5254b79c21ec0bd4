#include "app/project/options/option_values.h"

#include <charconv>
#include <cmath>

#include "app/project/options/options.h"

namespace wend {

std::string OptionValues::text(const std::string& flag) const {
    const auto it = m_values.find(flag);
    return it != m_values.end() ? it->second.back() : defaultText(option(flag));
}

std::vector<std::string> OptionValues::texts(const std::string& flag) const {
    const auto it = m_values.find(flag);
    return it != m_values.end() ? it->second : std::vector<std::string>();
}

double OptionValues::number(const std::string& flag) const {
    return given(flag).value_or(defaultOf(flag));
}

int OptionValues::place(const std::string& flag) const {
    return placeOf(option(flag), text(flag));
}

int OptionValues::integer(const std::string& flag) const {
    return static_cast<int>(number(flag));
}

std::optional<double> OptionValues::given(const std::string& flag) const {
    const auto it = m_values.find(flag);
    return it != m_values.end() ? finiteNumber(it->second.back()) : std::nullopt;
}

std::optional<double> finiteNumber(const std::string& text) {
    double value = 0;
    const char* end = text.data() + text.size();
    const auto done = std::from_chars(text.data(), end, value);
    if (done.ec != std::errc() || done.ptr != end || !std::isfinite(value)) return std::nullopt;
    return value;
}

}  // namespace wend
