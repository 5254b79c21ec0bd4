#include "app/output/overwriting.h"

#include <filesystem>

#include "app/output/output_set.h"
#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/project/file/motion_files.h"
#include "app/project/file/named_files.h"
#include "app/project/project.h"
#include "core/base/same_file.h"
#include "core/mesh/skin_file.h"

namespace wend {
namespace fs = std::filesystem;

namespace {

bool replacesAFile(const std::string& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    return !path.empty() && path != "-" && (!fs::exists(status) || fs::is_regular_file(status));
}

/// One place of an output, by the name that the user gave it.
struct Place {
    std::string file, output;
};

std::vector<Place> singlePlaces(const RunOutputs& outputs) {
    std::vector<Place> places;
    for (const std::string& path : outputs.singleFiles())
        if (replacesAFile(path))
            for (const std::string& file : writtenAlong(path)) places.push_back({file, path});
    return places;
}

std::string replaced(const Place& place, const std::vector<OwnInput>& inputs) {
    for (const OwnInput& input : inputs)
        if (sameFile(input.path, place.file))
            return place.output + ": would replace " + input.path + ", which is read here";
    return {};
}

/// Names a clash of frames that are there already, maybe as links, or that other outputs will be.
std::string clashOfFrames(const std::vector<OwnInput>& inputs, const std::vector<Place>& places,
                          const std::string& frames, int count) {
    for (const Place& place : places) {
        const auto number = frameNumber(canonicalName(frames), canonicalName(place.file));
        if (number && *number < count)
            return place.output + ": would be replaced by frame " + std::to_string(*number) + " of " + frames;
    }
    std::error_code error;
    for (int k = 0; k < count; ++k)
        for (const std::string& file : writtenAlong(frameName(frames, k)))
            if (fs::exists(file, error))
                if (const std::string clash = replaced({file, file}, inputs); !clash.empty()) return clash;
    return {};
}

std::string clashOfSequences(const FileNames& sequences, int count) {
    for (std::size_t k = 0; k < sequences.size(); ++k)
        for (std::size_t i = 0; i < k; ++i) {
            const std::string one = canonicalName(sequences[i]), other = canonicalName(sequences[k]);
            for (int frame = 0; frame < count; ++frame)
                if (const auto number = frameNumber(other, frameName(one, frame)); number && *number < count)
                    return sequences[k] + ": would replace frames of another output, " + sequences[i];
        }
    return {};
}

}  // namespace

std::vector<OwnInput> inputsOf(const Project& project, const std::string& path, const std::string& folder) {
    const Domain& domain = project.domain;
    std::vector<OwnInput> inputs;
    const auto add = [&](OwnFile kind, const std::string& file) {
        if (file.empty()) return;
        for (const std::string& one : writtenAlong(pathIn(folder, file))) inputs.push_back({kind, one});
    };
    if (!path.empty()) inputs.push_back({OwnFile::Project, path == "-" ? "/dev/stdin" : path});
    add(domain.kind == DomainKind::Image ? OwnFile::Picture : OwnFile::Mesh, domain.path);
    add(OwnFile::Picture, domain.texture);
    for (const PicturePart& part : domain.parts) add(OwnFile::Picture, part.path);
    add(OwnFile::Sizes, domain.sizesFile);
    add(OwnFile::Detail, domain.detail);
    add(OwnFile::Audio, project.audio);
    if (domain.kind != DomainKind::Image)
        for (const std::string& surface : {domain.path, domain.detail})
            if (!surface.empty())
                for (const std::string& file : lookFilesOf(pathIn(folder, surface)))
                    inputs.push_back({OwnFile::Look, file});
    const Design& own = project.design;
    add(OwnFile::Material, own.material.cellsFile);
    for (const Pin& handle : own.handles) {
        if (handle.slide) add(OwnFile::Mesh, handle.slide->file);
        for (const PinMotion& motion : handle.motions)
            if (const std::string* file = fileOf(motion.kind)) add(OwnFile::Motion, *file);
    }
    for (const MaterialRegion& region : regionsOf(own.material.layers))
        for (const std::string& file :
             {region.pictures.phi, region.pictures.stiffness, region.pictures.direction})
            add(OwnFile::Material, file);
    return inputs;
}

std::string overwriting(const std::vector<OwnInput>& inputs, const RunOutputs& outputs) {
    const std::vector<Place> places = singlePlaces(outputs);
    for (std::size_t k = 0; k < places.size(); ++k) {
        if (const std::string clash = replaced(places[k], inputs); !clash.empty()) return clash;
        for (std::size_t i = 0; i < k; ++i)
            if (sameFile(places[i].file, places[k].file))
                return places[k].output + ": would replace another output, " + places[i].output;
    }
    for (const std::string& frames : outputs.numberedFrames())
        if (const std::string clash = clashOfFrames(inputs, places, frames, outputs.count); !clash.empty())
            return clash;
    return clashOfSequences(outputs.numberedFrames(), outputs.count);
}

}  // namespace wend
