#include "app/session/selection.h"

#include <algorithm>

namespace wend {

bool Selection::contains(int handle) const {
    return std::binary_search(m_handles.begin(), m_handles.end(), handle);
}

void Selection::set(std::vector<int> handles) {
    std::sort(handles.begin(), handles.end());
    handles.erase(std::unique(handles.begin(), handles.end()), handles.end());
    if (handles == m_handles) return;
    m_handles = std::move(handles);
    emit changed();
}

void Selection::pick(const std::vector<int>& handles, Pick how) {
    std::vector<int> next;
    if (how != Pick::Only) next = m_handles;
    if (how == Pick::Remove)
        std::erase_if(next,
                      [&](int h) { return std::find(handles.begin(), handles.end(), h) != handles.end(); });
    else
        next.insert(next.end(), handles.begin(), handles.end());
    set(std::move(next));
}

void Selection::toggle(int handle) {
    std::vector<int> next = m_handles;
    if (const auto it = std::find(next.begin(), next.end(), handle); it != next.end())
        next.erase(it);
    else
        next.push_back(handle);
    set(std::move(next));
}

}  // namespace wend
