// SPDX-License-Identifier: AGPL-3.0-or-later
// A filter of GIMP 2.10: the layer bends as a project of Wend bends its picture, and comes back as a layer
// above it.
#include <gio/gio.h>
#include <libgimp/gimp.h>
#include <libgimp/gimpui.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr const char* kProcedure = "plug-in-wend-bend";

class Failure : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// A file in GIMP's folder for temporary ones, which goes with this.
class TemporaryFile {
  public:
    explicit TemporaryFile(const char* extension) {
        gchar* name = gimp_temp_name(extension);
        m_name = name;
        g_free(name);
    }
    ~TemporaryFile() { std::remove(m_name.c_str()); }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    const std::string& name() const { return m_name; }

  private:
    std::string m_name;
};

/// Runs the program, or what the environment variable WEND names, in a folder; returns its output.
std::string wend(std::vector<std::string> words, const fs::path& folder, const std::string& input = {}) {
    const char* program = g_getenv("WEND");
    words.insert(words.begin(), program ? program : "wend");
    std::vector<const gchar*> arguments;
    for (const std::string& word : words) arguments.push_back(word.c_str());
    arguments.push_back(nullptr);
    const auto flags = static_cast<GSubprocessFlags>(
        G_SUBPROCESS_FLAGS_STDIN_PIPE | G_SUBPROCESS_FLAGS_STDOUT_PIPE | G_SUBPROCESS_FLAGS_STDERR_PIPE);
    GSubprocessLauncher* launcher = g_subprocess_launcher_new(flags);
    g_subprocess_launcher_set_cwd(launcher, folder.c_str());
    GSubprocess* process = g_subprocess_launcher_spawnv(launcher, arguments.data(), nullptr);
    g_object_unref(launcher);
    if (!process) throw Failure("The program wend was not found. Please install Wend.");
    gchar *out = nullptr, *error = nullptr;
    g_subprocess_communicate_utf8(process, input.c_str(), nullptr, &out, &error, nullptr);
    const std::string output = out ? out : "", message = error ? g_strstrip(error) : "";
    const bool done = g_subprocess_get_successful(process);
    g_free(out);
    g_free(error);
    g_object_unref(process);
    if (!done) throw Failure(message);
    return output;
}

/// The drawable as a picture of the image's size, with transparency and the image's colour profile.
void savePicture(gint32 image, gint32 drawable, const std::string& name) {
    const gint32 copy =
        gimp_image_new_with_precision(gimp_image_width(image), gimp_image_height(image),
                                      gimp_image_base_type(image), gimp_image_get_precision(image));
    if (GimpColorProfile* profile = gimp_image_get_color_profile(image)) {
        gimp_image_set_color_profile(copy, profile);
        g_object_unref(profile);
    }
    const gint32 layer = gimp_layer_new_from_drawable(drawable, copy);
    gimp_image_insert_layer(copy, layer, -1, 0);
    gint x = 0, y = 0;
    gimp_drawable_offsets(drawable, &x, &y);
    gimp_layer_set_offsets(layer, x, y);
    gimp_layer_add_alpha(layer);
    gimp_layer_resize_to_image_size(layer);
    const gboolean saved = gimp_file_save(GIMP_RUN_NONINTERACTIVE, copy, layer, name.c_str(), name.c_str());
    gimp_image_delete(copy);
    if (!saved) throw Failure("The layer could not be written to " + name);
}

/// The project with another picture in the place of its own, which must have the same size.
Json withPicture(const fs::path& project, gint32 image, const std::string& picture) {
    std::ifstream file(project);
    Json json = Json::parse(file, nullptr, false);
    if (!json.is_object() || !json["domain"].is_object() || !json["domain"]["image"].is_string())
        throw Failure(project.string() + " is not a project of a single picture");
    const auto own = project.parent_path() / json["domain"]["image"].get<std::string>();
    const Json info = Json::parse(wend({"info", "--json", own.string()}, project.parent_path()));
    const int width = info.value("width", 0), height = info.value("height", 0);
    if (width != gimp_image_width(image) || height != gimp_image_height(image))
        throw Failure("The project bends a picture of " + std::to_string(width) + " × " +
                      std::to_string(height) + " pixels; this image has " +
                      std::to_string(gimp_image_width(image)) + " × " +
                      std::to_string(gimp_image_height(image)));
    json["domain"]["image"] = picture;
    return json;
}

/// Returns the bent layer, which lies above the drawable. Before time 0 stands for the end.
gint32 bend(gint32 image, gint32 drawable, const fs::path& project, double time) {
    const TemporaryFile before("png"), after("png");
    savePicture(image, drawable, before.name());
    std::vector<std::string> words{"run", "-", "--quiet", "--image", after.name()};
    std::array<gchar, G_ASCII_DTOSTR_BUF_SIZE> at{};
    if (time >= 0) words.insert(words.end(), {"--at", g_ascii_dtostr(at.data(), at.size(), time)});
    const fs::path whole = fs::absolute(project);
    wend(words, whole.parent_path(), withPicture(whole, image, before.name()).dump());
    const gint32 layer = gimp_file_load_layer(GIMP_RUN_NONINTERACTIVE, image, after.name().c_str());
    if (layer < 0) throw Failure("The bent picture could not be read");
    gchar* name = gimp_item_get_name(drawable);
    gimp_item_set_name(layer, (std::string(name) + ", bent").c_str());
    g_free(name);
    gimp_image_undo_group_start(image);
    gimp_image_insert_layer(image, layer, gimp_item_get_parent(drawable),
                            gimp_image_get_item_position(image, drawable));
    gimp_image_undo_group_end(image);
    return layer;
}

/// What is kept for the filter's next run.
struct Values {
    std::array<char, 4096> project{};
    double time = -1;
};

bool askForProject(Values& values) {
    gimp_ui_init("wend-bend", FALSE);
    GtkWidget* dialog =
        gtk_file_chooser_dialog_new("Bend with Wend", nullptr, GTK_FILE_CHOOSER_ACTION_OPEN, GTK_STOCK_CANCEL,
                                    GTK_RESPONSE_CANCEL, GTK_STOCK_OPEN, GTK_RESPONSE_OK, nullptr);
    GtkFileFilter* filter = gtk_file_filter_new();
    gtk_file_filter_set_name(filter, "Wend projects");
    gtk_file_filter_add_pattern(filter, "*.wend");
    gtk_file_chooser_add_filter(GTK_FILE_CHOOSER(dialog), filter);
    if (values.project[0]) gtk_file_chooser_set_filename(GTK_FILE_CHOOSER(dialog), values.project.data());
    const bool chosen = gtk_dialog_run(GTK_DIALOG(dialog)) == GTK_RESPONSE_OK;
    gchar* name = chosen ? gtk_file_chooser_get_filename(GTK_FILE_CHOOSER(dialog)) : nullptr;
    if (name) g_strlcpy(values.project.data(), name, values.project.size());
    g_free(name);
    gtk_widget_destroy(dialog);
    return chosen;
}

void query() {
    static const std::array<GimpParamDef, 5> parameters{{
        {GIMP_PDB_INT32, const_cast<gchar*>("run-mode"), const_cast<gchar*>("The run mode")},
        {GIMP_PDB_IMAGE, const_cast<gchar*>("image"), const_cast<gchar*>("The image")},
        {GIMP_PDB_DRAWABLE, const_cast<gchar*>("drawable"), const_cast<gchar*>("The layer that bends")},
        {GIMP_PDB_STRING, const_cast<gchar*>("project"), const_cast<gchar*>("The project, a file *.wend")},
        {GIMP_PDB_FLOAT, const_cast<gchar*>("time"), const_cast<gchar*>("The time to bend to; -1: the end")},
    }};
    static const GimpParamDef result{GIMP_PDB_LAYER, const_cast<gchar*>("layer"),
                                     const_cast<gchar*>("The bent layer")};
    gimp_install_procedure(
        kProcedure, "Bend the layer as a project of Wend bends its picture",
        "The bent layer is put above the layer. The image has the size of the project's picture.",
        "The authors of Wend", "AGPL-3.0-or-later", "2026", "_Bend with Wend…", "RGB*, GRAY*", GIMP_PLUGIN,
        parameters.size(), 1, parameters.data(), &result);
    gimp_plugin_menu_register(kProcedure, "<Image>/Filters/Distorts");
}

void run(const gchar*, gint count, const GimpParam* given, gint* returned, GimpParam** values) {
    static std::array<GimpParam, 2> results{};
    results[0].type = GIMP_PDB_STATUS;
    results[0].data.d_status = GIMP_PDB_SUCCESS;
    *returned = 1;
    *values = results.data();
    const auto mode = static_cast<GimpRunMode>(given[0].data.d_int32);
    Values last;
    gimp_get_data(kProcedure, &last);
    if (mode == GIMP_RUN_NONINTERACTIVE && count == 5) {
        g_strlcpy(last.project.data(), given[3].data.d_string, last.project.size());
        last.time = given[4].data.d_float;
    }
    if (mode == GIMP_RUN_INTERACTIVE && !askForProject(last)) {
        results[0].data.d_status = GIMP_PDB_CANCEL;
        return;
    }
    try {
        results[1].type = GIMP_PDB_LAYER;
        results[1].data.d_layer =
            bend(given[1].data.d_image, given[2].data.d_drawable, last.project.data(), last.time);
        *returned = 2;
        gimp_set_data(kProcedure, &last, sizeof last);
        if (mode != GIMP_RUN_NONINTERACTIVE) gimp_displays_flush();
    } catch (const std::exception& error) {
        static std::string message;
        message = error.what();
        results[0].data.d_status = GIMP_PDB_EXECUTION_ERROR;
        results[1].type = GIMP_PDB_STRING;
        results[1].data.d_string = message.data();
        *returned = 2;
    }
}

}  // namespace

extern "C" {
const GimpPlugInInfo PLUG_IN_INFO{nullptr, nullptr, query, run};
}
MAIN()
