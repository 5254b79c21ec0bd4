#include "warp/plugins.h"

#include <OpenImageIO/imageio.h>

#include <cstdlib>
#include <optional>
#include <string>

namespace wend {
namespace {

/// A variable of the environment that is not there for a while.
class Unset {
  public:
    explicit Unset(const char* name) : m_name(name) {
        if (const char* value = std::getenv(name)) m_value = value;
        unsetenv(name);
    }
    ~Unset() {
        if (m_value) setenv(m_name, m_value->c_str(), 1);
    }
    Unset(const Unset&) = delete;
    Unset& operator=(const Unset&) = delete;

  private:
    const char* m_name;
    std::optional<std::string> m_value;
};

}  // namespace

void lookForNoPlugins() {
    const Unset own("OIIO_LIBRARY_PATH"), all("LD_LIBRARY_PATH");
    OIIO::attribute("plugin_searchpath", "");
    OIIO::is_imageio_format_name("png");
}

}  // namespace wend
