#pragma once

#include <QObject>
#include <vector>

namespace wend {

/// The handles that are selected, by index, in increasing order.
class Selection : public QObject {
    Q_OBJECT

  public:
    using QObject::QObject;

    const std::vector<int>& handles() const { return m_handles; }
    bool isEmpty() const { return m_handles.empty(); }
    bool contains(int handle) const;
    void set(std::vector<int> handles);
    void toggle(int handle);
    /// Effect of picking items on the existing selection.
    enum class Pick { Only, Add, Remove };
    void pick(const std::vector<int>& handles, Pick how);
    void clear() { set({}); }

  signals:
    void changed();

  private:
    std::vector<int> m_handles;
};

}  // namespace wend
