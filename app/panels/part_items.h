#pragma once

#include <QIcon>
#include <QString>
#include <QStyledItemDelegate>

#include "app/project/part.h"

class QPalette;

namespace wend {

struct Image;

/// Returns the tooltip and accessible description of a part's line.
QString describedPart(const PicturePart& part);

/// Returns a small picture of what is opaque in a part's picture, with the sign of links if the part is
/// joined to another one. Null without a picture.
QIcon partIcon(const PicturePart& part, const Image* picture, const QPalette& palette);

/// Draws the rows of parts, each with a lock at its end, and emits a click on it.
class PartRow : public QStyledItemDelegate {
    Q_OBJECT

  public:
    static constexpr int kLockedRole = Qt::UserRole + 1;

    using QStyledItemDelegate::QStyledItemDelegate;
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;

  signals:
    void lockClicked(int row);

  protected:
    bool editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
                     const QModelIndex& index) override;
};

/// The sides of that picture, in pixels of the screen.
inline constexpr int kPartIcon = 28;

}  // namespace wend
