#include "app/output/film_outputs.h"

#include "app/output/output_set.h"
#include "core/base/error.h"
#include "warp/image.h"
#include "warp/warped_picture.h"

namespace wend {

Film& FilmOutputs::filmAt(const std::string& path) {
    if (const auto known = m_films.find(path); known != m_films.end()) return known->second;
    return m_films.try_emplace(path, path, m_files.begin(path), m_options).first->second;
}

void FilmOutputs::add(const std::vector<std::string>& paths, const WarpedPicture& picture) {
    if (paths.empty()) return;
    Image frame = picture.header();
    frame.makePixels();
    if (!picture.paint(0, frame)) throw Cancelled();
    for (const std::string& path : paths) {
        Film& film = filmAt(path);
        m_files.extend(path, [&] { film.add(frame); });
    }
}

void FilmOutputs::finish() {
    for (auto& [path, film] : m_films) m_files.extend(path, [&] { film.finish(); });
}

}  // namespace wend
