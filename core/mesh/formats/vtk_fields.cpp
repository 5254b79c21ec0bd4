#include "core/mesh/formats/vtk_fields.h"

#include <algorithm>
#include <type_traits>

#include "core/mesh/formats/mesh_bag.h"

namespace wend::formats {
namespace {

MeshField labelField(const MeshFile& bag) {
    MeshField field{"label", true,
                    1,       std::vector<double>(static_cast<std::size_t>(bag.cells.size()), 0.0),
                    {},      Scalar::Int32};
    for (std::size_t t = 0; t < bag.labels.size(); ++t)
        field.values[static_cast<std::size_t>(bag.cellOfTriangle[t])] = bag.labels[t];
    return field;
}

bool isLabel(const MeshField& field) {
    return field.perCell && field.components == 1 && field.name == "label";
}

bool isCellTag(const MeshField& field) {
    constexpr std::string_view tags[] = {"physical", "ref",   "attribute", "material",
                                         "marker",   "label", "pid",       "group"};
    return field.perCell && field.components == 1 && std::ranges::count(tags, field.name) > 0;
}

/// Returns whether a field of the file already holds the labels of the boundary.
bool tellsLabels(const MeshField& field, const MeshFile& bag) {
    if (!isCellTag(field)) return false;
    for (std::size_t t = 0; t < bag.labels.size(); ++t)
        if (field.values[static_cast<std::size_t>(bag.cellOfTriangle[t])] != bag.labels[t]) return false;
    return true;
}

}  // namespace

std::vector<MeshField> vtkFieldsOf(const MeshFile& bag) {
    auto fields = bag.fields;
    for (MeshField& field : fields)
        if (field.perCell) field.values = std::move(field.ofCells);
    const bool grouped =
        std::ranges::any_of(bag.groups, [](const auto& group) { return !group.cells.empty(); });
    if (!bag.labels.empty() && bag.labels.size() == bag.cellOfTriangle.size()) {
        if (std::ranges::any_of(fields, [&](const MeshField& field) { return tellsLabels(field, bag); }))
            return fields;
        std::erase_if(fields, isLabel);
        fields.push_back(labelField(bag));
    } else if (grouped && std::ranges::none_of(fields, isCellTag)) {
        const std::vector<long> numbers = groupNumbers(bag);
        fields.push_back({"group", true, 1, {numbers.begin(), numbers.end()}, {}, Scalar::Int32});
    }
    return fields;
}

template <class Whole>
std::vector<Whole> longNumbers(const MeshField& field) {
    constexpr bool isSigned = std::is_signed_v<Whole>;
    if (field.type != (isSigned ? Scalar::Int64 : Scalar::UInt64)) return {};
    constexpr double kLowest = isSigned ? -0x1p63 : 0, kBeyond = isSigned ? 0x1p63 : 0x1p64;
    std::vector<Whole> numbers;
    for (std::size_t i = 0; i < field.values.size(); ++i) {
        if (!(field.values[i] >= kLowest && field.values[i] <= kBeyond)) return {};
        const SplitNumber split{field.values[i], field.beyond.empty() ? std::int16_t(0) : field.beyond[i]};
        if constexpr (isSigned)
            numbers.push_back(wholeNumber(split));
        else
            numbers.push_back(unsignedNumber(split));
    }
    return numbers;
}

template std::vector<std::int64_t> longNumbers(const MeshField&);
template std::vector<std::uint64_t> longNumbers(const MeshField&);

}  // namespace wend::formats
