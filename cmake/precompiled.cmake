# Precompiled headers: most files spend most of their compilation on the same headers of Eigen, Qt and the standard library.
# There are three sets, because targets that link Qt have other compiler options, and a fourth for the most optimized
# targets (WEND_HOT). -DWEND_PCH=OFF builds without them, which finds missing includes.
option(WEND_PCH "Compile the headers that most files include once" ON)

set(WEND_PCH_STANDARD <algorithm> <array> <atomic> <cmath> <cstddef> <cstdint> <cstring> <filesystem> <fstream> <functional> <iterator>
    <limits> <map> <memory> <mutex> <numbers> <numeric> <optional> <set> <span> <sstream> <stdexcept> <stop_token> <string>
    <string_view> <thread> <utility> <variant> <vector> <Eigen/Core> <Eigen/Geometry> <Eigen/LU>)

# Qt headers that several files include; loading all of <QtWidgets> takes twice as long.
set(WEND_PCH_QT ${WEND_PCH_STANDARD} <QCoreApplication> <QDir> <QFile> <QFileInfo> <QHash> <QList> <QLocale> <QObject> <QPointer>
    <QPointF> <QRegularExpression> <QSet> <QSettings> <QString> <QStringList> <QThreadPool> <QTimer> <QVariant>)
set(WEND_PCH_WIDGETS ${WEND_PCH_QT} <QAction> <QActionGroup> <QApplication> <QBoxLayout> <QCheckBox> <QColor> <QComboBox>
    <QDoubleSpinBox> <QEvent> <QIcon> <QImage> <QKeyEvent> <QLabel> <QLineEdit> <QListWidget> <QMenu> <QMessageBox> <QMouseEvent>
    <QPainter> <QPainterPath> <QPixmap> <QPushButton> <QScrollBar> <QSlider> <QSpinBox> <QStatusBar> <QToolBar> <QToolButton>
    <QTreeWidget> <QUndoStack> <QWheelEvent> <QWidget>)

function(wend_precompile name)
    add_library(${name} OBJECT ${PROJECT_SOURCE_DIR}/cmake/precompiled.cpp)
    target_link_libraries(${name} PRIVATE wend_options Eigen3::Eigen ${ARGN})
endfunction()

if(WEND_PCH)
    foreach(set hot_core core)
        wend_precompile(wend_pch_${set})
        target_precompile_headers(wend_pch_${set} PRIVATE ${WEND_PCH_STANDARD})
        wend_hide_symbols(wend_pch_${set})  # a set needs the same options as the files that use it
    endforeach()
    foreach(set hot_qt qt)
        wend_precompile(wend_pch_${set} Qt6::Core)
        target_precompile_headers(wend_pch_${set} PRIVATE ${WEND_PCH_QT})
    endforeach()
    foreach(set hot_widgets widgets)
        wend_precompile(wend_pch_${set} Qt6::Widgets)
        target_precompile_headers(wend_pch_${set} PRIVATE ${WEND_PCH_WIDGETS})
    endforeach()
    foreach(set core qt widgets)
        target_compile_options(wend_pch_${set} PRIVATE ${WEND_USUAL_${set}})
    endforeach()
endif()

# wend_pch_kind(result LIBRARIES…): sets result to core, qt or widgets, the set that matches the linked libraries.
function(wend_pch_kind result)
    set(kind core)
    if(ARGN MATCHES "Qt6::Widgets|wend::(style|tools|panels|window|(picture|shape|volume)_view)")
        set(kind widgets)
    elseif(ARGN MATCHES "Qt6::|wend::(app_base|editing|engine|frame_output|session)")
        set(kind qt)
    endif()
    set(${result} ${kind} PARENT_SCOPE)
endfunction()

# wend_reuse_pch(target SET)
function(wend_reuse_pch target set)
    if(WEND_PCH)
        target_precompile_headers(${target} REUSE_FROM wend_pch_${set})
    endif()
endfunction()

# wend_use_pch(target LIBRARIES…)
function(wend_use_pch target)
    wend_pch_kind(kind ${ARGN})
    wend_reuse_pch(${target} ${kind})
endfunction()
