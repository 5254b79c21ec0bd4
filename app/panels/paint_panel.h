#pragma once

#include <QWidget>
#include <array>

#include "app/project/edits/document.h"
#include "app/session/brush.h"

class QComboBox;
class QStackedWidget;

namespace wend {

class EnergySlider;
class ExactBox;

/// The brush's paint on a picture or a solid. Its target and tip are beside the tool's name: see
/// BrushActions.
class PaintPanel : public QWidget {
    Q_OBJECT

  public:
    PaintPanel(Document& document, Brush& brush, QWidget* parent = nullptr);

  private:
    void makeControls();
    void arrange();
    QWidget* stiffPage();
    void connectControls();
    void setDimension(int dimension);
    void fillDirections();
    void chooseDirection(int index);
    void showBrush();
    template <class Change>
    void change(const Change& change);

    Document& m_document;
    Brush& m_brush;
    int m_dimension = 0;
    QStackedWidget* m_pages;
    EnergySlider* m_phi;
    ExactBox* m_ratio;
    QComboBox* m_direction;
    QWidget* m_numbersRow;
    std::array<ExactBox*, 3> m_numbers;
};

}  // namespace wend
