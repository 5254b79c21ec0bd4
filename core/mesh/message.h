#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace wend {

/// An English template, in which %1, %2 … stand for arguments.
struct Sentence {
    const char* text;
};

/// Marks a template for translators: lupdate finds the calls by this name (see scripts/translations.sh). The
/// context is "Core".
constexpr Sentence sentence(const char* /*context*/, const char* text) {
    return {text};
}

/// Returns the template with its %1, %2 … replaced by the arguments; other text is unchanged.
std::string filled(std::string_view sentence, const std::vector<std::string>& arguments);

/// What the core tells a user: a template and its arguments, which may be messages themselves, so that the
/// window can translate it; or a plain text, which stays as it is.
class Message {
  public:
    Message() = default;
    Message(std::string text) : m_text(std::move(text)) {}
    Message(const char* text) : m_text(text) {}
    template <class... Arguments>
    Message(Sentence sentence, const Arguments&... arguments)
        : Message(std::string(sentence.text), std::vector<Message>{argument(arguments)...}) {}
    /// Makes it of the parts that sentence() and arguments() return.
    Message(std::string sentence, std::vector<Message> arguments);

    /// Returns the English text.
    const std::string& text() const { return m_text; }
    /// Returns the English template; it is empty for a plain text.
    const std::string& sentence() const { return m_sentence; }
    const std::vector<Message>& arguments() const { return m_arguments; }

  private:
    static const Message& argument(const Message& message) { return message; }
    static Message argument(std::integral auto number) { return std::to_string(number); }

    std::string m_text;
    std::string m_sentence;
    std::vector<Message> m_arguments;
};

/// Returns one after the other, such as a subject and what is said of it.
inline Message operator+(const Message& first, const Message& second) {
    return {Sentence{"%1%2"}, first, second};
}

}  // namespace wend
