#include "app/panels/fields/panel_parts.h"

#include <QComboBox>
#include <QFrame>
#include <QRegularExpression>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/panels/fields/number_boxes.h"

namespace wend {

QLabel* panelTitle(const QString& text, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    label->setProperty("role", "title");
    return label;
}

QLabel* secondLabel(const QString& text, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    label->setProperty("role", "second");
    label->setTextFormat(Qt::PlainText);  // it may hold names from files
    label->setWordWrap(true);
    return label;
}

QFrame* panelLine(QWidget* parent) {
    auto* line = new QFrame(parent);
    line->setProperty("role", "line");
    line->setFixedHeight(1);
    return line;
}

QVBoxLayout* sectionColumn(QWidget* in) {
    auto* column = bareColumn(in, 10);
    column->setContentsMargins(16, 14, 16, 14);
    return column;
}

QVBoxLayout* bareColumn(QWidget* in, int spacing) {
    auto* column = new QVBoxLayout(in);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(spacing);
    return column;
}

QHBoxLayout* bareRow(QWidget* in, int spacing) {
    auto* row = new QHBoxLayout(in);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(spacing);
    return row;
}

QString tableLine(const QString& name, const QString& value) {
    return QStringLiteral("<tr><td>%1 &nbsp;</td><td>%2</td></tr>").arg(name.toHtmlEscaped(), value);
}

QHBoxLayout* sideBySide(std::initializer_list<QWidget*> widgets) {
    auto* row = new QHBoxLayout;
    for (QWidget* widget : widgets) widget ? row->addWidget(widget) : row->addStretch(1);
    return row;
}

QHBoxLayout* panelRow(const QString& label, QWidget* control, QWidget* parent) {
    auto* text = new QLabel(label, parent);
    text->setBuddy(control);
    if (qobject_cast<QAbstractSpinBox*>(control)) control->setFixedWidth(kControlWidth);
    auto* row = sideBySide({text, nullptr, control});
    row->setSpacing(8);
    return row;
}

QWidget* panelRowIn(const QString& label, QWidget* control, QWidget* parent) {
    auto* row = new QWidget(parent);
    auto* line = panelRow(label, control, row);
    line->setContentsMargins(0, 0, 0, 0);
    row->setLayout(line);
    return row;
}

void fitToEntries(QComboBox* box, int least) {
    box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    box->setMinimumWidth(least);
    box->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
}

std::array<ExactBox*, 3> coordinateBoxes(double limit, int decimals, const QString& name, const QString& help,
                                         QWidget* parent) {
    std::array<ExactBox*, 3> boxes{};
    for (ExactBox*& box : boxes) {
        box = new ExactBox(parent);
        box->setRange(-limit, limit);
        box->setDecimals(decimals);
        box->setButtonSymbols(QAbstractSpinBox::NoButtons);
        box->setMinimumWidth(56);
        box->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
        describe(box, name, help);
    }
    return boxes;
}

QString withoutKey(QString label) {
    static const QRegularExpression keyInBrackets(QStringLiteral("\\(&.\\)"));
    return label.remove(keyInBrackets).remove('&');
}

void describe(QWidget* widget, const QString& name, const QString& help) {
    widget->setAccessibleName(name);
    widget->setAccessibleDescription(help);
    widget->setToolTip(
        QStringLiteral("<p><b>%1</b></p><p>%2</p>").arg(name.toHtmlEscaped(), help.toHtmlEscaped()));
    widget->setStatusTip(help);
}

FoldingSection::FoldingSection(const QString& title, const QString& help, const QString& name,
                               QWidget* parent)
    : QWidget(parent),
      m_title(new QToolButton(this)),
      m_body(new QWidget(this)),
      m_parts(new QVBoxLayout(m_body)),
      m_isOpen(QStringLiteral("open/") + name) {
    setObjectName(name);
    m_title->setText(title);
    m_title->setCheckable(true);
    m_title->setProperty("role", "fold");
    m_title->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_title->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    describe(m_title, title, help);
    m_parts->setContentsMargins(0, 0, 0, 0);
    m_parts->setSpacing(0);
    auto* column = bareColumn(this, 0);
    column->addWidget(m_title);
    column->addWidget(m_body);
    connect(m_title, &QToolButton::toggled, this, [this](bool open) {
        m_body->setVisible(open);
        m_title->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
        m_isOpen.set(open);
    });
    m_title->setArrowType(Qt::RightArrow);
    m_body->hide();
    m_title->setChecked(m_isOpen.value());
}

void FoldingSection::add(QWidget* part) {
    m_parts->addWidget(part);
}

bool FoldingSection::isOpen() const {
    return m_title->isChecked();
}

void FoldingSection::setOpen(bool open) {
    m_title->setChecked(open);
}

}  // namespace wend
