#pragma once

#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/mesh/formats/scalar_type.h"

namespace wend {

/// The values of a data set or an attribute of an HDF5 file: numbers, or texts.
struct Hdf5Array {
    enum class Kind : std::uint8_t {
        None,  // of a kind that is not read
        Numbers,
        Texts
    };
    Kind kind = Kind::None;
    formats::Scalar type = formats::Scalar::Float64;  // of numbers
    std::uint8_t inner = 0;                           // of the shape, how many last extents belong to a type
    std::vector<std::int64_t> shape;                  // none: a single value
    std::string bytes;                                // numbers in native byte order
    std::vector<std::string> texts;
    std::int64_t textSize = 0;  // of texts that are written; 0: that of the longest

    /// Returns the number of values.
    std::size_t size() const;
    /// Returns the numbers. Throws InputError if these are texts.
    std::vector<double> reals() const;
    std::vector<std::int64_t> integers() const;
    /// Returns the first text, or numbers of one byte as a text up to the first 0.
    std::string text() const;

    static Hdf5Array of(std::span<const double> values, std::vector<std::int64_t> shape);
    static Hdf5Array of(std::span<const std::int64_t> values, std::vector<std::int64_t> shape,
                        formats::Scalar type = formats::Scalar::Int64);
    static Hdf5Array of(double value) { return of(std::span(&value, 1), {}); }
    static Hdf5Array of(std::int64_t value, formats::Scalar type) {
        return of(std::span<const std::int64_t>(&value, 1), {}, type);
    }
    static Hdf5Array of(std::string text, std::int64_t size = 0);
};

/// A group of an HDF5 file with what is in it, or a data set; both with their attributes.
struct Hdf5Node {
    std::string name;
    bool isGroup = true;
    Hdf5Array data;  // of a data set
    std::vector<std::pair<std::string, Hdf5Array>> attributes;
    std::vector<Hdf5Node> nodes;  // of a group

    /// Returns what is found along a path of names from here; null if there is nothing.
    const Hdf5Node* find(std::string_view path) const;
    /// Returns the data set at a path. Throws InputError if there is none.
    const Hdf5Array& at(std::string_view path) const;
    /// Returns an attribute; null if there is none of that name.
    const Hdf5Array* attribute(std::string_view name) const;

    /// Add a group or a data set, and return it.
    Hdf5Node& group(std::string name);
    Hdf5Node& dataSet(std::string name, Hdf5Array values);
    /// Adds an attribute, and returns this node.
    Hdf5Node& with(std::string name, Hdf5Array value);
};

/// Return the bytes of a tree as wend-hdf5 sends them, and a tree from those. Throws InputError for bytes
/// that are none.
std::string packed(const Hdf5Node& root);
Hdf5Node unpackedTree(std::string_view bytes);

/// Returns the content of an HDF5 file's bytes. Throws InputError.
Hdf5Node readHdf5(const std::string& bytes);
/// Returns the bytes of an HDF5 file with that content. Throws InputError.
std::string printHdf5(const Hdf5Node& root, bool compressed);
/// Returns whether bytes begin as those of an HDF5 file do.
bool isHdf5(std::string_view bytes);

}  // namespace wend
