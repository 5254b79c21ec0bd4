#pragma once

namespace wend {

/// The first byte of a message to wend-hdf5, before the bytes of a file or a packed tree …
constexpr char kHdf5Read = 'r', kHdf5Write = 'w', kHdf5Compress = 'c';
/// … and of its answer, before the tree or the bytes, or before the reason for none.
constexpr char kHdf5Done = 'd', kHdf5Failed = 'f';

}  // namespace wend
