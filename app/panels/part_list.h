#pragma once

#include <QIcon>
#include <QWidget>
#include <array>
#include <memory>
#include <vector>

#include "app/project/part.h"

class QComboBox;
class QListWidget;
class QListWidgetItem;
class QToolButton;

namespace wend {

class Document;
class ExactBox;
class PartOrderRow;
class Playback;
class ShapeMotion;
struct Image;
struct Texture;

/// Lists the parts of a picture, the frontmost first: an eye, a lock, a small picture, a name that a double
/// click changes, and an order that dragging and Alt with the arrow keys change. Below are the properties of
/// the chosen part: its opacity, soft edge, blend mode and joints, the part to which it is attached, and when
/// its order changes. Hidden for a picture of a single part.
class PartList : public QWidget {
    Q_OBJECT

  public:
    PartList(Document& document, ShapeMotion& motion, Playback& playback, QWidget* parent = nullptr);
    QListWidget* list() const { return m_list; }

  signals:
    /// Emitted with the place of the part that is chosen, −1 for none.
    void chosenChanged(int part);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;

  private:
    const std::vector<PicturePart>& parts() const;
    int chosen() const;
    void makeList();
    void makeChips();
    void makeFields();
    void showIcons();
    void showParts();
    void showChosen();
    void showPictures();
    void takeFrame();
    std::shared_ptr<const Texture> texture() const;
    void showBlend();
    void fillChoices();
    void allowJoints();
    void takeItem(QListWidgetItem* item);
    void takeOrder(int from, int to);
    void lock(int part, bool locked);
    void move(int by);
    void change(const QString& step, std::vector<PicturePart> parts, const QString& key = {});
    template <class Change>
    void changeChosen(const QString& step, const Change& change, const QString& key = {});
    void blend(int mode);
    void join(int place);
    void moveJoint(int axis, double value);
    void ride(int place);

    Document& m_document;
    ShapeMotion& m_motion;
    QListWidget* m_list;
    QToolButton *m_forward = nullptr, *m_backward = nullptr, *m_lock = nullptr;
    ExactBox *m_opacity = nullptr, *m_feather = nullptr;
    std::array<ExactBox*, 2> m_joint{};  // x and y of the joint
    QComboBox *m_blend = nullptr, *m_joined = nullptr, *m_rides = nullptr;
    PartOrderRow* m_order = nullptr;
    QWidget *m_rows = nullptr, *m_featherRow = nullptr, *m_jointRows = nullptr;
    std::shared_ptr<const Texture> m_texture;  // that the pictures are of
    /// Those of the pictures that are shown: making one takes milliseconds.
    struct Icon {
        std::shared_ptr<const Image> picture;
        bool isJoined;
        qint64 palette;
        QIcon icon;
    };
    std::vector<Icon> m_icons;
};

}  // namespace wend
