#include <hdf5.h>

#include <algorithm>
#include <stdexcept>

#include "core/mesh/hdf5/hdf5_handle.h"
#include "core/mesh/hdf5/hdf5_reading.h"

namespace wend {
namespace {

using formats::Scalar;

hid_t typeOf(Scalar type) {
    switch (type) {
        case Scalar::Int8:
            return H5T_NATIVE_INT8;
        case Scalar::UInt8:
            return H5T_NATIVE_UINT8;
        case Scalar::Int16:
            return H5T_NATIVE_INT16;
        case Scalar::UInt16:
            return H5T_NATIVE_UINT16;
        case Scalar::Int32:
            return H5T_NATIVE_INT32;
        case Scalar::UInt32:
            return H5T_NATIVE_UINT32;
        case Scalar::Int64:
            return H5T_NATIVE_INT64;
        case Scalar::UInt64:
            return H5T_NATIVE_UINT64;
        case Scalar::Float32:
            return H5T_NATIVE_FLOAT;
        case Scalar::Float64:
            break;
    }
    return H5T_NATIVE_DOUBLE;
}

void require(herr_t result) {
    if (result < 0) throw std::runtime_error("the HDF5 library cannot write it");
}

/// The type, the extents and the bytes of values as the library takes them.
class Values {
  public:
    explicit Values(const Hdf5Array& array) : m_type(makeType(array)), m_space(makeSpace(array)) {
        if (array.kind != Hdf5Array::Kind::Texts) {
            m_bytes = array.bytes;
            return;
        }
        for (const auto& text : array.texts) {
            std::string one = text;
            one.resize(H5Tget_size(m_type.id()), '\0');
            m_bytes += one;
        }
    }
    hid_t type() const { return m_type.id(); }
    hid_t space() const { return m_space.id(); }
    const char* data() const { return m_bytes.data(); }
    bool empty() const { return m_bytes.empty(); }

  private:
    static hid_t makeType(const Hdf5Array& array) {
        if (array.kind == Hdf5Array::Kind::Texts) {
            std::size_t size = static_cast<std::size_t>(array.textSize);
            for (const auto& text : array.texts)
                if (array.textSize == 0) size = std::max(size, text.size() + 1);
            const hid_t type = H5Tcopy(H5T_C_S1);
            H5Tset_size(type, std::max<std::size_t>(size, 1));
            return type;
        }
        if (array.inner == 0) return H5Tcopy(typeOf(array.type));
        const std::vector<hsize_t> inner(array.shape.end() - array.inner, array.shape.end());
        return H5Tarray_create2(typeOf(array.type), array.inner, inner.data());
    }
    static hid_t makeSpace(const Hdf5Array& array) {
        const std::vector<hsize_t> extents(array.shape.begin(), array.shape.end() - array.inner);
        if (extents.empty()) return H5Screate(H5S_SCALAR);
        return H5Screate_simple(static_cast<int>(extents.size()), extents.data(), nullptr);
    }

    Handle m_type, m_space;
    std::string m_bytes;
};

class Writing {
  public:
    explicit Writing(bool compressed) : m_compressed(compressed), m_ofGroups(H5Pcreate(H5P_GROUP_CREATE)) {
        H5Pset_link_creation_order(m_ofGroups.id(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
        H5Pset_obj_track_times(m_ofGroups.id(), false);
    }
    void write(hid_t group, const Hdf5Node& node) const {
        writeAttributes(group, node);
        for (const Hdf5Node& child : node.nodes) {
            if (!child.isGroup) {
                writeData(group, child);
                continue;
            }
            const Handle made(
                H5Gcreate2(group, child.name.c_str(), H5P_DEFAULT, m_ofGroups.id(), H5P_DEFAULT));
            require(made.id() < 0 ? -1 : 0);
            write(made.id(), child);
        }
    }

  private:
    void writeData(hid_t group, const Hdf5Node& node) const {
        const Values values(node.data);
        const Handle settings(H5Pcreate(H5P_DATASET_CREATE));
        H5Pset_obj_track_times(settings.id(), false);
        if (m_compressed && node.data.bytes.size() > 4096 && node.data.inner == 0)
            compress(settings.id(), node.data);
        const Handle made(H5Dcreate2(group, node.name.c_str(), values.type(), values.space(), H5P_DEFAULT,
                                     settings.id(), H5P_DEFAULT));
        require(made.id() < 0 ? -1 : 0);
        if (!values.empty())
            require(H5Dwrite(made.id(), values.type(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()));
        writeAttributes(made.id(), node);
    }
    /// Chunks of about a megabyte along the first extent.
    static void compress(hid_t settings, const Hdf5Array& array) {
        std::vector<hsize_t> chunk(array.shape.begin(), array.shape.end());
        const std::size_t row = array.bytes.size() / static_cast<std::size_t>(array.shape[0]);
        chunk[0] = std::clamp<hsize_t>((1U << 20) / std::max<std::size_t>(row, 1), 1, chunk[0]);
        H5Pset_chunk(settings, static_cast<int>(chunk.size()), chunk.data());
        H5Pset_shuffle(settings);
        H5Pset_deflate(settings, 6);
    }
    static void writeAttributes(hid_t object, const Hdf5Node& node) {
        for (const auto& [name, array] : node.attributes) {
            const Values values(array);
            const Handle made(
                H5Acreate2(object, name.c_str(), values.type(), values.space(), H5P_DEFAULT, H5P_DEFAULT));
            require(made.id() < 0 ? -1 : 0);
            require(H5Awrite(made.id(), values.type(), values.data()));
        }
    }

    bool m_compressed;
    Handle m_ofGroups;
};

}  // namespace

std::string fileOfTree(const Hdf5Node& root, bool compressed) {
    const Handle access(H5Pcreate(H5P_FILE_ACCESS)), creation(H5Pcreate(H5P_FILE_CREATE));
    H5Pset_fapl_core(access.id(), 1U << 20, 0);
    H5Pset_link_creation_order(creation.id(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
    H5Pset_obj_track_times(creation.id(), false);
    const Handle file(H5Fcreate("image", H5F_ACC_TRUNC, creation.id(), access.id()));
    require(file.id() < 0 ? -1 : 0);
    {
        const Handle group(H5Gopen2(file.id(), "/", H5P_DEFAULT));
        require(group.id() < 0 ? -1 : 0);
        Writing(compressed).write(group.id(), root);
    }
    require(H5Fflush(file.id(), H5F_SCOPE_LOCAL));
    const ssize_t size = H5Fget_file_image(file.id(), nullptr, 0);
    require(size < 0 ? -1 : 0);
    std::string bytes(static_cast<std::size_t>(size), '\0');
    require(H5Fget_file_image(file.id(), bytes.data(), bytes.size()) < 0 ? -1 : 0);
    return bytes;
}

}  // namespace wend
