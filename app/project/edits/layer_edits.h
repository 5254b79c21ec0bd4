#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "app/project/design.h"
#include "app/project/edits/free_name.h"

namespace wend {

// Edits of a list of layers: ValueLayer or MaterialLayer.

/// Returns the layer of that id; null if there is none.
template <class Layers>
auto* layerOf(Layers& layers, Id id) {
    const auto it = std::ranges::find_if(layers, [&](const auto& layer) { return layer.id == id; });
    return it == layers.end() ? nullptr : &*it;
}

/// Returns the wanted name, with a number appended if another layer or something in `taken` has it.
template <class Layer>
std::string freeLayerName(const std::vector<Layer>& layers, Id id, const std::string& wish,
                          std::vector<std::string> taken = {}) {
    for (const Layer& layer : layers)
        if (layer.id != id) taken.push_back(layer.name);
    return std::ranges::count(taken, wish) ? freeName(taken, wish, 2) : wish;
}

/// Gives a layer of the material another name where the one directly below it has the same: a file would join
/// them, and the erasers of the upper one would take paint from both.
inline void keepApart(std::vector<MaterialLayer>& layers) {
    for (std::size_t i = 1; i < layers.size(); ++i)
        if (!layers[i].name.empty() && layers[i].name == layers[i - 1].name)
            layers[i].name = freeLayerName(layers, layers[i].id, layers[i].name);
}
/// Layers of one name and value mean the same when they are joined.
inline void keepApart(std::vector<ValueLayer>&) {}

/// Returns the layers with a change of one of them; all as they are if it is not there.
template <class Layer, class Change>
std::vector<Layer> withLayer(std::vector<Layer> layers, Id id, const Change& change) {
    if (Layer* layer = layerOf(layers, id)) change(*layer);
    return layers;
}

template <class Layer>
std::vector<Layer> withLayerName(std::vector<Layer> layers, Id id, const std::string& wish,
                                 const std::vector<std::string>& taken = {}) {
    const std::string name = freeLayerName(layers, id, wish, taken);
    return withLayer(std::move(layers), id, [&](Layer& layer) { layer.name = name; });
}

/// Moves the layer by that many layers up, where it wins over more of the others; down if negative.
template <class Layer>
std::vector<Layer> withLayerMoved(std::vector<Layer> layers, Id id, int by) {
    const auto at = std::ranges::find(layers, id, &Layer::id);
    if (at == layers.end()) return layers;
    const auto to =
        layers.begin() + std::clamp<std::ptrdiff_t>(at - layers.begin() + by, 0, std::ssize(layers) - 1);
    if (to > at) std::rotate(at, at + 1, to + 1);
    if (to < at) std::rotate(to, at, at + 1);
    keepApart(layers);
    return layers;
}

template <class Layer>
std::vector<Layer> withoutLayer(std::vector<Layer> layers, Id id) {
    std::erase_if(layers, [&](const Layer& layer) { return layer.id == id; });
    keepApart(layers);
    return layers;
}

}  // namespace wend
