#include "core/mesh/hdf5/hdf5_reading.h"

#include <hdf5.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "core/mesh/hdf5/hdf5_handle.h"

namespace wend {
namespace {

using formats::Scalar;

constexpr int kDeepestLink = 30;
constexpr std::uint64_t kInflation = 2000;  // the most that data are larger than the bytes that hold them
constexpr std::uint64_t kFree = 16U << 20;  // bytes that any file may fill
constexpr std::uint64_t kMostNodes = 1000000;

struct Native {
    Scalar type;
    hid_t id;
};

/// Returns the type that numbers of a file's type are read as.
Native nativeOf(hid_t type, bool isReal) {
    const std::size_t size = H5Tget_size(type);
    if (isReal)
        return size <= 4 ? Native{Scalar::Float32, H5T_NATIVE_FLOAT}
                         : Native{Scalar::Float64, H5T_NATIVE_DOUBLE};
    const bool isSigned = H5Tget_sign(type) != H5T_SGN_NONE;
    if (size <= 1)
        return isSigned ? Native{Scalar::Int8, H5T_NATIVE_INT8} : Native{Scalar::UInt8, H5T_NATIVE_UINT8};
    if (size <= 2)
        return isSigned ? Native{Scalar::Int16, H5T_NATIVE_INT16} : Native{Scalar::UInt16, H5T_NATIVE_UINT16};
    if (size <= 4)
        return isSigned ? Native{Scalar::Int32, H5T_NATIVE_INT32} : Native{Scalar::UInt32, H5T_NATIVE_UINT32};
    return isSigned ? Native{Scalar::Int64, H5T_NATIVE_INT64} : Native{Scalar::UInt64, H5T_NATIVE_UINT64};
}

class Reading {
  public:
    explicit Reading(std::size_t fileBytes) : m_most(kInflation * fileBytes + kFree) {}

    /// Reads a group or a data set that is open.
    Hdf5Node node(hid_t object, const std::string& name, int depth) {
        if (++m_count > kMostNodes) throw std::runtime_error("has too many groups and data sets");
        Hdf5Node node;
        node.name = name;
        node.isGroup = H5Iget_type(object) == H5I_GROUP;
        readAttributes(object, node);
        if (!node.isGroup) {
            const Handle type(H5Dget_type(object)), space(H5Dget_space(object));
            node.data = values(type.id(), space.id(), name, [&](hid_t as, void* to) {
                return H5Dread(object, as, H5S_ALL, H5S_ALL, H5P_DEFAULT, to);
            });
        } else if (depth < kDeepestLink) {
            readLinks(object, node, depth);
        }
        return node;
    }

  private:
    /// Reads what a group links to within its file, in the order of its making if that is known. What is
    /// above it is not entered again.
    void readLinks(hid_t group, Hdf5Node& node, int depth) {
        H5O_info_t own;
        if (H5Oget_info(group, &own) < 0 || !m_above.insert(own.addr).second) return;
        H5G_info_t info;
        if (H5Gget_info(group, &info) < 0) throw std::runtime_error("has a damaged group");
        const Handle settings(H5Gget_create_plist(group));
        unsigned order = 0;
        H5Pget_link_creation_order(settings.id(), &order);
        const H5_index_t index = (order & H5P_CRT_ORDER_INDEXED) != 0 ? H5_INDEX_CRT_ORDER : H5_INDEX_NAME;
        for (hsize_t i = 0; i < info.nlinks; ++i) {
            const ssize_t length =
                H5Lget_name_by_idx(group, ".", index, H5_ITER_INC, i, nullptr, 0, H5P_DEFAULT);
            if (length < 0) throw std::runtime_error("has a damaged group");
            std::string name(static_cast<std::size_t>(length) + 1, '\0');
            H5Lget_name_by_idx(group, ".", index, H5_ITER_INC, i, name.data(), name.size(), H5P_DEFAULT);
            name.pop_back();
            H5L_info_t link;
            if (H5Lget_info(group, name.c_str(), &link, H5P_DEFAULT) < 0 ||
                (link.type != H5L_TYPE_HARD && link.type != H5L_TYPE_SOFT))
                continue;
            const Handle child(H5Oopen(group, name.c_str(), H5P_DEFAULT));
            const H5I_type_t kind = child.id() < 0 ? H5I_BADID : H5Iget_type(child.id());
            if (kind == H5I_GROUP || kind == H5I_DATASET)
                node.nodes.push_back(this->node(child.id(), name, depth + 1));
            else if (link.type == H5L_TYPE_HARD && kind == H5I_BADID)
                throw std::runtime_error("has a damaged entry \"" + name + "\"");
        }
        m_above.erase(own.addr);
    }
    void readAttributes(hid_t object, Hdf5Node& node) {
        H5O_info_t info;
        if (H5Oget_info(object, &info) < 0) return;
        for (hsize_t i = 0; i < info.num_attrs; ++i) {
            const Handle attribute(
                H5Aopen_by_idx(object, ".", H5_INDEX_NAME, H5_ITER_INC, i, H5P_DEFAULT, H5P_DEFAULT));
            if (attribute.id() < 0) continue;
            std::string name(256, '\0');
            const ssize_t length = H5Aget_name(attribute.id(), name.size(), name.data());
            name.resize(static_cast<std::size_t>(std::clamp<ssize_t>(length, 0, 255)));
            const Handle type(H5Aget_type(attribute.id())), space(H5Aget_space(attribute.id()));
            node.with(name, values(type.id(), space.id(), name,
                                   [&](hid_t as, void* to) { return H5Aread(attribute.id(), as, to); }));
        }
    }

    /// Reads values through `read`; what is neither numbers nor texts is left out.
    template <class Read>
    Hdf5Array values(hid_t fileType, hid_t space, const std::string& name, const Read& read) {
        Hdf5Array array;
        const int rank = H5Sget_simple_extent_ndims(space);
        const hssize_t count = H5Sget_simple_extent_npoints(space);
        if (rank < 0 || count < 0 || H5Sget_simple_extent_type(space) == H5S_NULL) return array;
        std::vector<hsize_t> extents(static_cast<std::size_t>(rank));
        H5Sget_simple_extent_dims(space, extents.data(), nullptr);
        array.shape.assign(extents.begin(), extents.end());
        require(static_cast<std::uint64_t>(count), H5Tget_size(fileType), name);
        const H5T_class_t kind = H5Tget_class(fileType);
        if (kind == H5T_STRING) {
            readTexts(fileType, static_cast<std::size_t>(count), array, space, read);
        } else if (kind == H5T_INTEGER || kind == H5T_FLOAT) {
            const Native native = nativeOf(fileType, kind == H5T_FLOAT);
            readNumbers(native, native.id, static_cast<std::size_t>(count), array, read);
        } else if (kind == H5T_ENUM) {
            const Handle base(H5Tget_super(fileType));
            const Native native = nativeOf(base.id(), false);
            readNumbers(native, native.id, static_cast<std::size_t>(count), array, read);
        } else if (kind == H5T_ARRAY) {
            readArrays(fileType, static_cast<std::size_t>(count), array, read);
        }
        return array;
    }
    /// Throws if a damaged file claims more than it can hold.
    void require(std::uint64_t count, std::uint64_t size, const std::string& name) {
        if (size == 0 || count > m_most / size || (m_total += count * size) > m_most)
            throw std::runtime_error("the data set \"" + name + "\" is larger than the file can hold");
    }
    template <class Read>
    static void readNumbers(const Native& native, hid_t as, std::size_t count, Hdf5Array& array,
                            const Read& read) {
        array.kind = Hdf5Array::Kind::Numbers;
        array.type = native.type;
        array.bytes.resize(count * formats::sizeOf(native.type));
        if (count > 0 && read(as, array.bytes.data()) < 0) throw std::runtime_error("has damaged data");
    }
    template <class Read>
    void readArrays(hid_t type, std::size_t count, Hdf5Array& array, const Read& read) {
        const Handle base(H5Tget_super(type));
        const H5T_class_t kind = H5Tget_class(base.id());
        const int rank = H5Tget_array_ndims(type);
        if ((kind != H5T_INTEGER && kind != H5T_FLOAT) || rank < 1) return;
        std::vector<hsize_t> extents(static_cast<std::size_t>(rank));
        H5Tget_array_dims2(type, extents.data());
        for (const hsize_t extent : extents) {
            array.shape.push_back(static_cast<std::int64_t>(extent));
            count *= extent;
        }
        array.inner = static_cast<std::uint8_t>(rank);
        const Native native = nativeOf(base.id(), kind == H5T_FLOAT);
        require(count, formats::sizeOf(native.type), "of arrays");
        const Handle as(H5Tarray_create2(native.id, static_cast<unsigned>(rank), extents.data()));
        readNumbers(native, as.id(), count, array, read);
    }
    template <class Read>
    void readTexts(hid_t type, std::size_t count, Hdf5Array& array, hid_t space, const Read& read) {
        array.kind = Hdf5Array::Kind::Texts;
        const Handle as(H5Tcopy(H5T_C_S1));
        H5Tset_cset(as.id(), H5Tget_cset(type));
        if (H5Tis_variable_str(type) > 0) {
            H5Tset_size(as.id(), H5T_VARIABLE);
            std::vector<char*> texts(count, nullptr);
            if (count > 0 && read(as.id(), texts.data()) < 0) throw std::runtime_error("has damaged texts");
            for (const char* text : texts) array.texts.emplace_back(text ? text : "");
            H5Dvlen_reclaim(as.id(), space, H5P_DEFAULT, texts.data());
            return;
        }
        const std::size_t size = H5Tget_size(type) + 1;
        H5Tset_size(as.id(), size);
        std::string bytes(count * size, '\0');
        if (count > 0 && read(as.id(), bytes.data()) < 0) throw std::runtime_error("has damaged texts");
        for (std::size_t i = 0; i < count; ++i) {
            const std::string one = bytes.substr(i * size, size);
            array.texts.push_back(one.substr(0, one.find('\0')));
        }
    }

    std::uint64_t m_most, m_total = 0, m_count = 0;
    std::set<haddr_t> m_above;  // the groups that are being read
};

}  // namespace

Hdf5Node treeOfFile(std::string& bytes) {
    const Handle settings(H5Pcreate(H5P_FILE_ACCESS));
    H5Pset_fapl_core(settings.id(), 1U << 16, 0);
    H5Pset_file_image(settings.id(), bytes.data(), bytes.size());
    const Handle file(H5Fopen("image", H5F_ACC_RDONLY, settings.id()));
    if (file.id() < 0) throw std::runtime_error("the HDF5 library cannot open it: the file may be damaged");
    const Handle root(H5Gopen2(file.id(), "/", H5P_DEFAULT));
    if (root.id() < 0) throw std::runtime_error("has a damaged group");
    return Reading(bytes.size()).node(root.id(), "", 0);
}

}  // namespace wend
