#include "core/base/message.h"

#include <charconv>
#include <utility>

#include "core/base/error.h"

namespace wend {

namespace {

constexpr std::size_t kDeepest = 100;  // messages in messages

/// Reads numbers, each followed by a colon, and texts of known length.
class Unpacking {
  public:
    explicit Unpacking(std::string_view bytes) : m_bytes(bytes) {}

    Message message(std::size_t depth = 0) {
        if (depth > kDeepest) fail();
        std::string text = take(number());
        const std::size_t count = number();
        if (count == 0) return text;
        std::vector<Message> arguments;
        for (std::size_t i = 1; i < count; ++i) arguments.push_back(message(depth + 1));
        return {std::move(text), std::move(arguments)};
    }
    void finish() const {
        if (!m_bytes.empty()) fail();
    }

  private:
    [[noreturn]] static void fail() { throw InputError("is no message"); }
    std::size_t number() {
        std::size_t value = 0;
        const auto [end, error] = std::from_chars(m_bytes.data(), m_bytes.data() + m_bytes.size(), value);
        const auto length = static_cast<std::size_t>(end - m_bytes.data());
        if (error != std::errc() || length == m_bytes.size() || m_bytes[length] != ':') fail();
        m_bytes.remove_prefix(length + 1);
        return value;
    }
    std::string take(std::size_t length) {
        if (length > m_bytes.size()) fail();
        std::string text(m_bytes.substr(0, length));
        m_bytes.remove_prefix(length);
        return text;
    }

    std::string_view m_bytes;
};

}  // namespace

std::string filled(std::string_view sentence, const std::vector<std::string>& arguments) {
    std::string result;
    for (std::size_t i = 0; i < sentence.size(); ++i) {
        const bool isPlace = sentence[i] == '%' && i + 1 < sentence.size() && sentence[i + 1] >= '1';
        const std::size_t number =
            isPlace ? static_cast<std::size_t>(sentence[i + 1] - '1') : arguments.size();
        if (number < arguments.size()) {
            result += arguments[number];
            ++i;
        } else {
            result += sentence[i];
        }
    }
    return result;
}

Message::Message(std::string sentence, std::vector<Message> arguments)
    : m_sentence(std::move(sentence)), m_arguments(std::move(arguments)) {
    std::vector<std::string> texts;
    texts.reserve(m_arguments.size());
    for (const Message& one : m_arguments) texts.push_back(one.text());
    m_text = filled(m_sentence, texts);
}

Message listed(const std::vector<Message>& messages) {
    Message list;
    for (const Message& one : messages)
        if (!one.isEmpty()) list += list.isEmpty() ? one : Message(", ") + one;
    return list;
}

std::vector<std::string> textsOf(const std::vector<Message>& messages) {
    return {messages.begin(), messages.end()};
}

Message withTexts(const Message& message, const std::function<std::string(const std::string&)>& change) {
    if (message.sentence().empty()) return change(message.text());
    std::vector<Message> arguments;
    for (const Message& argument : message.arguments()) arguments.push_back(withTexts(argument, change));
    return {message.sentence(), std::move(arguments)};
}

std::string packed(const Message& message) {
    const bool isPlain = message.sentence().empty();
    const std::string& text = isPlain ? message.text() : message.sentence();
    const std::size_t count = isPlain ? 0 : message.arguments().size() + 1;
    std::string bytes = std::to_string(text.size()) + ':' + text + std::to_string(count) + ':';
    for (const Message& argument : message.arguments()) bytes += packed(argument);
    return bytes;
}

Message unpackedMessage(std::string_view bytes) {
    Unpacking unpacking(bytes);
    Message message = unpacking.message();
    unpacking.finish();
    return message;
}

}  // namespace wend
