#include "core/mesh/message.h"

#include <utility>

namespace wend {

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

}  // namespace wend
