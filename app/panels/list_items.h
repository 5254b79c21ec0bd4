#pragma once

#include <QIcon>
#include <QItemDelegate>
#include <QString>

#include "app/project/edits/material_edits.h"
#include "app/project/part.h"

class QAbstractItemView;
class QListWidgetItem;
class QPalette;

namespace wend {

/// Returns a square in the colour of the layer's energy, or of stiffness if it only changes that.
QIcon layerSwatch(const MaterialPaint& paint, int dimension);
/// Returns a square from black to white, for values that come from a picture or differ per cell.
QIcon graySwatch();

/// Store and return the layer of an item of a list; Id::None for none, or without an item.
void setLayerOf(QListWidgetItem& item, Id layer);
Id layerOf(const QListWidgetItem* item);

/// Keeps the scroll position of a list whose rows are made anew during its lifetime, as far as the current
/// row stays visible.
class KeptScroll {
  public:
    explicit KeptScroll(QAbstractItemView& list);
    ~KeptScroll();
    KeptScroll(const KeptScroll&) = delete;
    KeptScroll& operator=(const KeptScroll&) = delete;

  private:
    QAbstractItemView& m_list;
    int m_scrolled;
};

/// Draws an eye, open or closed, in the place of the box that is ticked.
class EyeDelegate : public QItemDelegate {
    Q_OBJECT

  public:
    using QItemDelegate::QItemDelegate;

  protected:
    void drawCheck(QPainter* painter, const QStyleOptionViewItem& option, const QRect& rect,
                   Qt::CheckState state) const override;
};

struct Image;

/// Returns the tooltip and accessible description of a part's line.
QString describedPart(const PicturePart& part);

/// Returns a small picture of what is opaque in a part's picture, with the sign of links if the part is
/// joined to another one. Null without a picture.
QIcon partIcon(const PicturePart& part, const Image* picture, const QPalette& palette);

/// Draws the rows of parts, each with an eye and with a lock at its end, and emits a click on the lock.
class PartRow : public EyeDelegate {
    Q_OBJECT

  public:
    static constexpr int kLockedRole = Qt::UserRole + 1;

    using EyeDelegate::EyeDelegate;
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

  signals:
    void lockClicked(int row);

  protected:
    bool editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
                     const QModelIndex& index) override;
};

/// The sides of that picture, in pixels of the screen.
inline constexpr int kPartIcon = 28;

}  // namespace wend
