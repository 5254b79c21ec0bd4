#pragma once

#include <QObject>
#include <vector>

#include "app/project/id.h"

namespace wend {

class Document;

/// The selected pins of a document. They are kept by their ids, so that they stay selected when others come,
/// go or change places; pins are named by their places in the project as it is now.
class Selection : public QObject {
    Q_OBJECT

  public:
    explicit Selection(const Document& document) : m_document(document) {}

    /// Returns the places of the selected pins in increasing order.
    std::vector<int> handles() const;
    /// Returns the pin if one alone is selected, else −1.
    int single() const;
    bool isEmpty() const { return m_ids.empty(); }
    bool contains(int handle) const;
    /// Selects the pins at these places; there is none at others.
    void set(const std::vector<int>& handles);
    void toggle(int handle);
    /// Effect of picking items on the existing selection.
    enum class Pick { Only, Add, Remove };
    void pick(const std::vector<int>& handles, Pick how);
    void clear() { set({}); }
    /// Forgets pins that the project no longer has.
    void prune();

  signals:
    void changed();

  private:
    void setIds(std::vector<Id> ids);

    const Document& m_document;
    std::vector<Id> m_ids;  // sorted
};

}  // namespace wend
