#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "core/base/message.h"
#include "warp/picture_library.h"
#include "warp/vector_drawing.h"

namespace wend {

/// Messages between the program and wend-picture are CBOR objects without a version, because both are built
/// together. The program asks for {"path", "megapixels"}, or {"path"} for the header alone, both also with
/// {"layer"} and {"drawn"}, the size of a drawing; or for {"path", "vectors"}: the one answer is {"vectors"}.
/// Answers:
/// {"layout", "rows"}: the picture's layout, and how many rows the shared memory is to hold, whose number as
/// text confirms it; {"taken"}: that many rows are in it, confirmed by an empty text. The last answer is
/// {"picture"}, or {"wrong", "isSound"}: the reason, and whether the process can continue, or {"memory"}:
/// there was too little.
using PictureMessage = nlohmann::json;

/// Convert a message for a user to a value, and back. Throw nlohmann::json::exception and InputError for
/// invalid values.
PictureMessage binaryOf(const Message& text);
Message textOf(const PictureMessage& binary);

std::string pack(const PictureMessage& message);
/// Throws nlohmann::json::exception for anything else.
PictureMessage unpackMessage(const std::string& bytes);

/// Convert a picture without its pixels to a value of a message, and back. Throw nlohmann::json::exception
/// and InputError for invalid values.
PictureMessage messageOf(const StoredPicture& stored);
StoredPicture pictureOf(const PictureMessage& message);

/// Convert a drawing.
PictureMessage messageOf(const VectorDrawing& drawing);
VectorDrawing drawingOf(const PictureMessage& message);

}  // namespace wend
