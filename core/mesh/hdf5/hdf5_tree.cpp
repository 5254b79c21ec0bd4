#include "core/mesh/hdf5/hdf5_tree.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "core/base/error.h"
#include "core/mesh/formats/scanner.h"

namespace wend {
namespace {

using formats::Scalar;

constexpr int kDeepestGroup = 32;

/// Appends numbers, texts and lists, each with its length.
class TreeWriter {
  public:
    void number(std::uint64_t value) { m_bytes.append(reinterpret_cast<const char*>(&value), sizeof value); }
    void text(std::string_view value) {
        number(value.size());
        m_bytes += value;
    }
    void array(const Hdf5Array& array) {
        number(static_cast<std::uint64_t>(array.kind));
        number(static_cast<std::uint64_t>(array.type));
        number(array.inner);
        number(static_cast<std::uint64_t>(array.textSize));
        number(array.shape.size());
        for (const auto extent : array.shape) number(static_cast<std::uint64_t>(extent));
        text(array.bytes);
        number(array.texts.size());
        for (const auto& one : array.texts) text(one);
    }
    void node(const Hdf5Node& node) {
        text(node.name);
        number(node.isGroup ? 1 : 0);
        array(node.data);
        number(node.attributes.size());
        for (const auto& [name, value] : node.attributes) {
            text(name);
            array(value);
        }
        number(node.nodes.size());
        for (const auto& child : node.nodes) this->node(child);
    }
    std::string take() { return std::move(m_bytes); }

  private:
    std::string m_bytes;
};

class TreeReader {
  public:
    explicit TreeReader(std::string_view bytes) : m_bytes(bytes) {}

    std::uint64_t number() {
        std::uint64_t value = 0;
        require(sizeof value);
        std::memcpy(&value, m_bytes.data(), sizeof value);
        m_bytes.remove_prefix(sizeof value);
        return value;
    }
    std::string text() {
        const auto size = number();
        require(size);
        std::string value(m_bytes.substr(0, size));
        m_bytes.remove_prefix(size);
        return value;
    }
    /// Returns the length of a list, whose elements take eight bytes at least.
    std::size_t count() {
        const auto value = number();
        if (value > m_bytes.size() / 8) fail();
        return value;
    }
    Hdf5Array array() {
        Hdf5Array array;
        const auto kind = number(), type = number();
        if (kind > 2 || type > static_cast<std::uint64_t>(Scalar::Float64)) fail();
        array.kind = static_cast<Hdf5Array::Kind>(kind);
        array.type = static_cast<Scalar>(type);
        array.inner = static_cast<std::uint8_t>(number());
        array.textSize = static_cast<std::int64_t>(number());
        array.shape.resize(count());
        for (auto& extent : array.shape) extent = static_cast<std::int64_t>(number());
        array.bytes = text();
        array.texts.resize(count());
        for (auto& one : array.texts) one = text();
        return array;
    }
    Hdf5Node node(int depth = 0) {
        if (depth > kDeepestGroup) fail();
        Hdf5Node node;
        node.name = text();
        node.isGroup = number() != 0;
        node.data = array();
        node.attributes.resize(count());
        for (auto& [name, value] : node.attributes) {
            name = text();
            value = array();
        }
        node.nodes.resize(count());
        for (auto& child : node.nodes) child = this->node(depth + 1);
        return node;
    }

  private:
    [[noreturn]] static void fail() { throw InputError("the reader of HDF5 files gave a strange answer"); }
    void require(std::uint64_t size) const {
        if (size > m_bytes.size()) fail();
    }
    std::string_view m_bytes;
};

}  // namespace

std::size_t Hdf5Array::size() const {
    return kind == Kind::Texts ? texts.size() : bytes.size() / formats::sizeOf(type);
}

std::vector<double> Hdf5Array::reals() const {
    if (kind != Kind::Numbers) throw InputError("texts stand where numbers are needed");
    std::vector<double> values(size());
    const std::size_t step = formats::sizeOf(type);
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] =
            formats::decodeReal(std::string_view(bytes).substr(i * step, step), type, std::endian::native);
    return values;
}

std::vector<std::int64_t> Hdf5Array::integers() const {
    if (kind != Kind::Numbers) throw InputError("texts stand where numbers are needed");
    std::vector<std::int64_t> values(size());
    const std::size_t step = formats::sizeOf(type);
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] =
            formats::decodeInteger(std::string_view(bytes).substr(i * step, step), type, std::endian::native);
    return values;
}

std::string Hdf5Array::text() const {
    std::string text = kind == Kind::Texts && !texts.empty() ? texts.front() : bytes;
    text.resize(std::min(text.size(), text.find('\0')));
    return text;
}

Hdf5Array Hdf5Array::of(std::span<const double> values, std::vector<std::int64_t> shape) {
    Hdf5Array array;
    array.kind = Kind::Numbers;
    array.shape = std::move(shape);
    array.bytes.assign(reinterpret_cast<const char*>(values.data()), values.size_bytes());
    return array;
}

Hdf5Array Hdf5Array::of(std::span<const std::int64_t> values, std::vector<std::int64_t> shape, Scalar type) {
    Hdf5Array array;
    array.kind = Kind::Numbers;
    array.type = type;
    array.shape = std::move(shape);
    for (const auto value : values) formats::appendInteger(array.bytes, value, type, std::endian::native);
    return array;
}

Hdf5Array Hdf5Array::of(std::string text, std::int64_t size) {
    Hdf5Array array;
    array.kind = Kind::Texts;
    array.texts = {std::move(text)};
    array.textSize = size;
    return array;
}

const Hdf5Node* Hdf5Node::find(std::string_view path) const {
    const Hdf5Node* node = this;
    while (!path.empty()) {
        const auto end = std::min(path.find('/'), path.size());
        const auto found = std::ranges::find(node->nodes, path.substr(0, end), &Hdf5Node::name);
        if (found == node->nodes.end()) return nullptr;
        node = &*found;
        path.remove_prefix(std::min(end + 1, path.size()));
    }
    return node;
}

const Hdf5Array& Hdf5Node::at(std::string_view path) const {
    const Hdf5Node* node = find(path);
    if (!node || node->isGroup)
        throw InputError("there is no data set " + formats::inQuotes(path) + " in " +
                         (name.empty() ? "it" : formats::inQuotes(name)));
    return node->data;
}

const Hdf5Array* Hdf5Node::attribute(std::string_view wanted) const {
    for (const auto& [known, value] : attributes)
        if (known == wanted) return &value;
    return nullptr;
}

Hdf5Node& Hdf5Node::group(std::string child) {
    nodes.push_back({std::move(child), true, {}, {}, {}});
    return nodes.back();
}

Hdf5Node& Hdf5Node::dataSet(std::string child, Hdf5Array values) {
    nodes.push_back({std::move(child), false, std::move(values), {}, {}});
    return nodes.back();
}

Hdf5Node& Hdf5Node::with(std::string attribute, Hdf5Array value) {
    attributes.emplace_back(std::move(attribute), std::move(value));
    return *this;
}

std::string packed(const Hdf5Node& root) {
    TreeWriter writer;
    writer.node(root);
    return writer.take();
}

Hdf5Node unpackedTree(std::string_view bytes) {
    return TreeReader(bytes).node();
}

bool isHdf5(std::string_view bytes) {
    return bytes.starts_with("\x89HDF\r\n\x1a\n");
}

}  // namespace wend
