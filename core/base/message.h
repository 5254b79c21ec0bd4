#pragma once

#include <concepts>
#include <functional>
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

/// Returns the template with its %1, %2 … replaced by the arguments; other text is unchanged. There are at
/// most nine arguments, %1 to %9; an argument is not filled in turn, so a % in a file's name stays.
std::string filled(std::string_view sentence, const std::vector<std::string>& arguments);

/// A message for a user: a template and its arguments, which may be messages themselves, so that the window
/// can translate it; or a plain text, which stays as it is. Where a string is wanted it is its English text.
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
    operator const std::string&() const { return m_text; }
    bool isEmpty() const { return m_text.empty(); }
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

/// Returns one after the other, such as a subject and its predicate.
inline Message operator+(const Message& first, const Message& second) {
    return {Sentence{"%1%2"}, first, second};
}
inline Message& operator+=(Message& first, const Message& second) {
    return first = first.isEmpty() ? second : first + second;
}
inline bool operator==(const Message& message, std::string_view text) {
    return std::string_view(message.text()) == text;
}

/// Returns the messages one after another with ", " between them; empty ones are left out.
Message listed(const std::vector<Message>& messages);

/// Returns the English texts of messages.
std::vector<std::string> textsOf(const std::vector<Message>& messages);

/// Returns the message with its plain texts changed.
Message withTexts(const Message& message, const std::function<std::string(const std::string&)>& change);

/// Returns a message as bytes for another process, and reads them again. Throws InputError for other bytes.
/// Messages in messages may be nested up to a hundred deep.
std::string packed(const Message& message);
Message unpackedMessage(std::string_view bytes);

}  // namespace wend
