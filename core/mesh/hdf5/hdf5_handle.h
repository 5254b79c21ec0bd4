#pragma once

#include <hdf5.h>

namespace wend {

/// Anything that the HDF5 library has open, and closes with this object.
class Handle {
  public:
    explicit Handle(hid_t id) : m_id(id) {}
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    ~Handle() {
        if (m_id >= 0) H5Idec_ref(m_id);
    }
    hid_t id() const { return m_id; }

  private:
    hid_t m_id;
};

}  // namespace wend
