#pragma once

#include <fstream>
#include <string>

#include "core/base/safe_file.h"
#include "core/base/types.h"

namespace wend {

/// Keeps poses that have to wait, such as until the size of a canvas for all of them is known. They are on
/// the disk, since a long sequence would fill the memory, and are deleted with this object.
class PoseFile {
  public:
    /// Makes the file in the folder of `path`, which errors name.
    explicit PoseFile(const std::string& path);

    /// Appends a pose; all have one size. Throws InputError when the disk is full.
    void add(const Points<2>& pose);
    int count() const { return m_count; }
    /// Returns the k-th pose, bit for bit.
    Points<2> read(int k);

  private:
    std::string m_path;
    TemporaryFolder m_folder;
    std::fstream m_stream;
    Eigen::Index m_columns = 0;
    int m_count = 0;
};

}  // namespace wend
