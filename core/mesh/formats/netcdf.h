#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/mesh/hdf5/hdf5_tree.h"

namespace wend::formats {

/// Returns the variables of a netCDF file as data sets, with their attributes; those of the file are the
/// root's. Files of the fourth version are HDF5 files. Throws InputError.
Hdf5Node readNetcdf(const std::string& bytes);

/// A variable of a netCDF file that is written, with the names of its dimensions.
struct NetcdfVariable {
    std::string name;
    std::vector<std::string> dimensions;
    Hdf5Array values;  // double, 32-bit whole numbers or bytes, which are text
    std::vector<std::pair<std::string, std::string>> attributes;
};
/// Returns the bytes of a netCDF file of the classic form with 64-bit offsets. The dimension "time_step" has
/// no fixed length; the others have those of the values, or are among `more`.
std::string printNetcdf(const std::vector<NetcdfVariable>& variables,
                        const std::vector<std::pair<std::string, Hdf5Array>>& attributes,
                        const std::vector<std::pair<std::string, std::int64_t>>& more = {});

}  // namespace wend::formats
