#include "api/boundary.h"

#include <filesystem>

#include "core/base/error.h"
#include "core/base/input_file.h"
#include "core/base/memory.h"

namespace wend {

InvalidInput::InvalidInput(const std::string& what) : std::runtime_error(what) {}
InvalidInput::~InvalidInput() = default;

InsufficientMemory::InsufficientMemory(const std::string& what, double needed)
    : m_what(what), m_needed(needed) {}
InsufficientMemory::~InsufficientMemory() = default;
const char* InsufficientMemory::what() const noexcept {
    return m_what.c_str();
}

Interrupted::~Interrupted() = default;
const char* Interrupted::what() const noexcept {
    return "interrupted";
}

void rethrowDocumented() try { throw; } catch (const InputError& error) {
    throw InvalidInput(error.what());
} catch (const NotEnoughMemory& error) {
    throw InsufficientMemory(error.what(), error.needed());
} catch (const OutOfMemory& error) {
    throw InsufficientMemory(error.what(), 0);
} catch (const Cancelled&) {
    throw Interrupted();
} catch (const std::filesystem::filesystem_error& error) {
    throw InvalidInput(error.what());
}

}  // namespace wend
