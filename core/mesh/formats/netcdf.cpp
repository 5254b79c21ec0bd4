// The classic form of netCDF: a header with dimensions, attributes and variables, then the values, all in
// big-endian order (NetCDF Classic Format Specification).

#include "core/mesh/formats/netcdf.h"

#include <algorithm>
#include <bit>
#include <map>
#include <optional>

#include "core/base/error.h"
#include "core/mesh/formats/scanner.h"

namespace wend::formats {
namespace {

constexpr int kDimensions = 10, kVariables = 11, kAttributes = 12;
constexpr std::int64_t kMostValues = std::int64_t(1) << 40;
constexpr const char* kSteps = "time_step";

/// Returns the type of a netCDF number; nothing for one that is none. Text is bytes.
std::optional<Scalar> scalarOf(std::int64_t type) {
    constexpr Scalar kTypes[] = {Scalar::Int8,    Scalar::Int8,    Scalar::Int16, Scalar::Int32,
                                 Scalar::Float32, Scalar::Float64, Scalar::UInt8, Scalar::UInt16,
                                 Scalar::UInt32,  Scalar::Int64,   Scalar::UInt64};
    if (type < 1 || type > 11) return std::nullopt;
    return kTypes[type - 1];
}

std::size_t padded(std::size_t size) {
    return (size + 3) / 4 * 4;
}

class ClassicReader {
  public:
    explicit ClassicReader(std::string_view bytes) : m_bytes(bytes) {}

    Hdf5Node read() {
        m_version = static_cast<unsigned char>(m_bytes[3]);
        m_at = 4;
        m_records = count();
        readDimensions();
        Hdf5Node root;
        readAttributes(root);
        const std::int64_t variables = list(kVariables);
        std::vector<Variable> all;
        for (std::int64_t v = 0; v < variables; ++v) all.push_back(variable());
        std::size_t recordSize = 0, ofRecords = 0;
        for (const Variable& one : all)
            if (one.isRecord) recordSize += padded(one.bytes), ++ofRecords;
        if (ofRecords == 1)  // a single one is not padded
            for (const Variable& one : all)
                if (one.isRecord) recordSize = one.bytes;
        for (Variable& one : all) readValues(one, recordSize, root);
        return root;
    }

  private:
    struct Variable {
        Hdf5Node node;
        bool isRecord = false;
        std::size_t bytes = 0, begin = 0;  // of one record, or of all
    };

    [[noreturn]] static void fail() { throw InputError("the netCDF file is damaged"); }
    std::string_view take(std::size_t size) {
        if (size > m_bytes.size() - m_at) fail();
        m_at += size;
        return m_bytes.substr(m_at - size, size);
    }
    std::int64_t number(std::size_t size) {
        return decodeInteger(take(size), size == 8 ? Scalar::Int64 : Scalar::Int32, std::endian::big);
    }
    std::int64_t count() { return number(m_version == 5 ? 8 : 4); }
    /// Returns the length of a list, each of whose entries takes four bytes at least.
    std::int64_t list(int tag) {
        const std::int64_t own = number(4), length = count();
        if ((own != tag && (own != 0 || length != 0)) || length < 0 || length > std::ssize(m_bytes) / 4)
            fail();
        return length;
    }
    std::string name() {
        const std::int64_t size = count();
        if (size < 0) fail();
        std::string text(take(static_cast<std::size_t>(size)));
        take(padded(text.size()) - text.size());
        return text;
    }
    void readDimensions() {
        const std::int64_t dimensions = list(kDimensions);
        for (std::int64_t d = 0; d < dimensions; ++d) {
            name();
            m_lengths.push_back(count());
            if (m_lengths.back() < 0) fail();
        }
    }
    void readAttributes(Hdf5Node& node) {
        const std::int64_t attributes = list(kAttributes);
        for (std::int64_t a = 0; a < attributes; ++a) {
            const std::string own = name();
            const auto type = scalarOf(number(4));
            const std::int64_t length = count();
            if (!type || length < 0 || length > std::ssize(m_bytes)) fail();
            const std::size_t size = static_cast<std::size_t>(length) * sizeOf(*type);
            node.with(own, valuesOf(take(size), *type, {length}));
            take(padded(size) - size);
        }
    }
    static Hdf5Array valuesOf(std::string_view bytes, Scalar type, std::vector<std::int64_t> shape) {
        Hdf5Array array;
        array.kind = Hdf5Array::Kind::Numbers;
        array.type = type;
        array.shape = std::move(shape);
        const std::size_t step = sizeOf(type);
        array.bytes.reserve(bytes.size());
        for (std::size_t at = 0; at + step <= bytes.size(); at += step) {
            std::string one(bytes.substr(at, step));
            if constexpr (std::endian::native == std::endian::little) std::ranges::reverse(one);
            array.bytes += one;
        }
        return array;
    }
    Variable variable() {
        Variable one;
        one.node.name = name();
        one.node.isGroup = false;
        const std::int64_t rank = count();
        if (rank < 0 || rank > std::ssize(m_bytes) / 4) fail();
        std::int64_t values = 1;
        for (std::int64_t k = 0; k < rank; ++k) {
            const std::int64_t dimension = count();
            if (dimension < 0 || dimension >= std::ssize(m_lengths)) fail();
            const std::int64_t length = m_lengths[static_cast<std::size_t>(dimension)];
            if (length == 0) {
                if (k > 0) fail();
                one.isRecord = true;
            } else {
                if (values > kMostValues / length) fail();
                values *= length;
            }
            one.node.data.shape.push_back(length == 0 ? m_records : length);
        }
        readAttributes(one.node);
        const auto type = scalarOf(number(4));
        if (!type) fail();
        one.node.data.type = *type;
        count();  // its size, which follows from the rest
        one.begin = static_cast<std::size_t>(number(m_version == 1 ? 4 : 8));
        one.bytes = static_cast<std::size_t>(values) * sizeOf(*type);
        return one;
    }
    void readValues(Variable& one, std::size_t recordSize, Hdf5Node& root) {
        std::string bytes;
        const std::int64_t records = one.isRecord ? m_records : 1;
        if (records < 0 || (one.isRecord && records > std::ssize(m_bytes))) fail();
        for (std::int64_t r = 0; r < records; ++r) {
            const std::size_t at = one.begin + static_cast<std::size_t>(r) * recordSize;
            if (at > m_bytes.size() || one.bytes > m_bytes.size() - at) fail();
            if ((m_total += one.bytes) > 4 * m_bytes.size()) fail();  // variables share no bytes
            bytes += m_bytes.substr(at, one.bytes);
        }
        one.node.data = valuesOf(bytes, one.node.data.type, one.node.data.shape);
        root.nodes.push_back(std::move(one.node));
    }

    std::string_view m_bytes;
    std::size_t m_at = 0;
    int m_version = 1;
    std::int64_t m_records = 0;
    std::size_t m_total = 0;  // bytes of values
    std::vector<std::int64_t> m_lengths;
};

class ClassicPrinter {
  public:
    ClassicPrinter(const std::vector<NetcdfVariable>& variables,
                   const std::vector<std::pair<std::string, std::int64_t>>& more)
        : m_variables(variables), m_dimensions(more) {
        for (std::size_t d = 0; d < more.size(); ++d) m_numbers.emplace(more[d].first, d);
        for (const NetcdfVariable& variable : variables)
            for (std::size_t k = 0; k < variable.dimensions.size(); ++k)
                if (!m_numbers.contains(variable.dimensions[k])) {
                    m_numbers.emplace(variable.dimensions[k], m_dimensions.size());
                    m_dimensions.emplace_back(variable.dimensions[k], variable.values.shape[k]);
                }
    }

    std::string print(const std::vector<std::pair<std::string, Hdf5Array>>& attributes) {
        m_out = "CDF\x02";
        number(m_numbers.contains(kSteps) ? m_dimensions[m_numbers[kSteps]].second : 0);
        list(kDimensions, m_dimensions.size());
        for (const auto& [name, length] : m_dimensions) {
            text(name);
            number(name == kSteps ? 0 : length);
        }
        list(kAttributes, attributes.size());
        for (const auto& [name, value] : attributes) attribute(name, value);
        printVariables();
        return std::move(m_out);
    }

  private:
    static bool isRecord(const NetcdfVariable& variable) {
        return !variable.dimensions.empty() && variable.dimensions[0] == kSteps;
    }
    /// Returns the bytes of one record, or of all values.
    static std::size_t bytesOf(const NetcdfVariable& variable) {
        const auto records = isRecord(variable) ? variable.values.shape[0] : 1;
        return records == 0 ? 0 : variable.values.bytes.size() / static_cast<std::size_t>(records);
    }
    void number(std::int64_t value) { appendInteger(m_out, value, Scalar::Int32, std::endian::big); }
    void list(int tag, std::size_t length) {
        number(length == 0 ? 0 : tag);
        number(static_cast<std::int64_t>(length));
    }
    void pad() { m_out.resize(padded(m_out.size()), '\0'); }
    void text(const std::string& value) {
        number(std::ssize(value));
        m_out += value;
        pad();
    }
    static int typeOf(Scalar type) {
        constexpr int kText = 2, kInt = 4, kFloat = 5, kDouble = 6;
        return type == Scalar::Int8      ? kText
               : type == Scalar::Int32   ? kInt
               : type == Scalar::Float32 ? kFloat
                                         : kDouble;
    }
    void attribute(const std::string& name, const Hdf5Array& value) {
        text(name);
        number(typeOf(value.type));
        number(static_cast<std::int64_t>(value.size()));
        values(value.bytes, value.type);
        pad();
    }
    void values(std::string_view bytes, Scalar type) {
        const std::size_t step = sizeOf(type);
        for (std::size_t at = 0; at < bytes.size(); at += step) {
            std::string one(bytes.substr(at, step));
            if constexpr (std::endian::native == std::endian::little) std::ranges::reverse(one);
            m_out += one;
        }
    }
    /// Prints the header of every variable, then values of fixed length, then those of every record.
    void printVariables() {
        list(kVariables, m_variables.size());
        std::vector<std::size_t> places;  // of the beginnings in the header
        for (const NetcdfVariable& variable : m_variables) {
            text(variable.name);
            number(std::ssize(variable.dimensions));
            for (const auto& dimension : variable.dimensions)
                number(static_cast<std::int64_t>(m_numbers[dimension]));
            list(kAttributes, variable.attributes.size());
            for (const auto& [name, value] : variable.attributes) {
                Hdf5Array array;
                array.type = Scalar::Int8;
                array.bytes = value;
                attribute(name, array);
            }
            number(typeOf(variable.values.type));
            number(static_cast<std::int64_t>(std::min<std::size_t>(padded(bytesOf(variable)), 0x7fffffff)));
            places.push_back(m_out.size());
            m_out.append(8, '\0');
        }
        const auto begin = [&](std::size_t v) {
            std::string place;
            appendInteger(place, std::ssize(m_out), Scalar::Int64, std::endian::big);
            m_out.replace(places[v], place.size(), place);
        };
        for (std::size_t v = 0; v < m_variables.size(); ++v)
            if (!isRecord(m_variables[v])) {
                begin(v);
                values(m_variables[v].values.bytes, m_variables[v].values.type);
                pad();
            }
        for (std::size_t v = 0; v < m_variables.size(); ++v)  // a single record
            if (isRecord(m_variables[v])) {
                begin(v);
                values(m_variables[v].values.bytes, m_variables[v].values.type);
                pad();
            }
    }

    const std::vector<NetcdfVariable>& m_variables;
    std::vector<std::pair<std::string, std::int64_t>> m_dimensions;
    std::map<std::string, std::size_t> m_numbers;
    std::string m_out;
};

}  // namespace

Hdf5Node readNetcdf(const std::string& bytes) {
    if (isHdf5(bytes)) return readHdf5(bytes);
    const bool isClassic =
        bytes.size() > 8 && bytes.starts_with("CDF") && (bytes[3] == 1 || bytes[3] == 2 || bytes[3] == 5);
    if (!isClassic) throw InputError("is no netCDF file");
    return ClassicReader(bytes).read();
}

std::string printNetcdf(const std::vector<NetcdfVariable>& variables,
                        const std::vector<std::pair<std::string, Hdf5Array>>& attributes,
                        const std::vector<std::pair<std::string, std::int64_t>>& more) {
    return ClassicPrinter(variables, more).print(attributes);
}

}  // namespace wend::formats
