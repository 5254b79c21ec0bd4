#pragma once

#include <QWidget>
#include <array>
#include <optional>

#include "app/session/shape_session.h"

class QComboBox;
class QHBoxLayout;
class QLabel;
class QToolButton;

namespace wend {

class ExactBox;

/// Numbers of the selection: its place, exact steps, and the path of a single handle.
class HandlePanel : public QWidget {
    Q_OBJECT

  public:
    explicit HandlePanel(ShapeSession& session, QWidget* parent = nullptr);

  private:
    void makeControls();
    void arrange();
    void showHandle();
    void showStep();
    void placeNumbers();
    void changeEvent(QEvent* event) override;
    void apply();
    std::optional<Vec3> middle() const;
    bool isSolid() const { return m_session.document().dimension() == 3; }

    ShapeSession& m_session;
    QLabel* m_none;
    QWidget* m_body;
    QLabel* m_place;
    QComboBox* m_kind;
    std::array<ExactBox*, 3> m_numbers;
    QComboBox* m_axis;
    QToolButton* m_apply;
    QHBoxLayout *m_step = nullptr, *m_space = nullptr;
};

}  // namespace wend
