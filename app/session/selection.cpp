#include "app/session/selection.h"

#include <algorithm>

#include "app/project/design.h"
#include "app/project/edits/document.h"

namespace wend {

namespace {

const std::vector<Pin>& pinsOf(const Document& document) {
    static const std::vector<Pin> none;
    return document.isEmpty() ? none : document.design().handles;
}

}  // namespace

std::vector<int> Selection::handles() const {
    std::vector<int> handles;
    const int count = static_cast<int>(pinsOf(m_document).size());
    for (int h = 0; h < count; ++h)
        if (contains(h)) handles.push_back(h);
    return handles;
}

int Selection::single() const {
    const std::vector<int> selected = handles();
    return selected.size() == 1 ? selected.front() : -1;
}

bool Selection::contains(int handle) const {
    const std::vector<Pin>& pins = pinsOf(m_document);
    return handle >= 0 && handle < std::ssize(pins) && std::ranges::binary_search(m_ids, pins[handle].id);
}

void Selection::set(const std::vector<int>& handles) {
    std::vector<Id> ids;
    for (const int h : handles)
        if (h >= 0 && h < std::ssize(pinsOf(m_document))) ids.push_back(pinsOf(m_document)[h].id);
    setIds(std::move(ids));
}

void Selection::setIds(std::vector<Id> ids) {
    std::ranges::sort(ids);
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    if (ids == m_ids) return;
    m_ids = std::move(ids);
    emit changed();
}

void Selection::pick(const std::vector<int>& handles, Pick how) {
    std::vector<int> next;
    if (how != Pick::Only) next = this->handles();
    if (how == Pick::Remove)
        std::erase_if(next, [&](int h) { return std::ranges::count(handles, h); });
    else
        next.insert(next.end(), handles.begin(), handles.end());
    set(next);
}

void Selection::toggle(int handle) {
    pick({handle}, contains(handle) ? Pick::Remove : Pick::Add);
}

void Selection::prune() {
    std::vector<Id> ids = m_ids;
    std::erase_if(ids, [&](Id id) { return !std::ranges::count(pinsOf(m_document), id, &Pin::id); });
    setIds(std::move(ids));
}

}  // namespace wend
