#pragma once

#include <map>
#include <string>
#include <vector>

#include "warp/film.h"

namespace wend {

class OutputSet;

/// The films of a run. Each is encoded while frames come, and is whole with the other outputs or not there.
class FilmOutputs {
  public:
    /// `files` must outlive this object.
    FilmOutputs(OutputSet& files, FilmOptions options) : m_files(files), m_options(std::move(options)) {}

    /// Adds the picture to the films with these names. Throws InputError and Cancelled.
    void add(const std::vector<std::string>& paths, const WarpedPicture& picture);
    /// Completes all films. Throws InputError and Cancelled.
    void finish();
    /// Ends the work on all films; their files are the output set's to discard.
    void discard() { m_films.clear(); }
    bool any() const { return !m_films.empty(); }

  private:
    Film& filmAt(const std::string& path);

    OutputSet& m_files;
    FilmOptions m_options;
    std::map<std::string, Film> m_films;
};

}  // namespace wend
