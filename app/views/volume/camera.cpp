#include "app/views/volume/camera.h"

#include <QString>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace wend {

namespace {

constexpr double kFieldOfView = 35 * std::numbers::pi / 180;
constexpr double kMargin = 1.22;  // around the fitted content
const double kTanHalf = std::tan(kFieldOfView / 2);

Eigen::Quaterniond turn(const Vec3& direction, const Vec3& up) {
    Mat3 rows;
    rows.row(2) = -direction.normalized();
    rows.row(0) = up.cross(rows.row(2).transpose()).normalized();
    rows.row(1) = rows.row(2).cross(rows.row(0));
    return Eigen::Quaterniond(rows);
}

/// Rounds to a millionth of `size`.
Vec3 rounded(const Vec3& p, double size) {
    const int digits = std::clamp(6 - static_cast<int>(std::floor(std::log10(size))), 0, 300);
    return p.unaryExpr([&](double x) { return QString::number(x, 'f', digits).toDouble(); });
}

constexpr double kRadiansPerPixel = 0.008;
constexpr double kClickPixels = 4;

}  // namespace

void Camera::fit(const Vec3& low, const Vec3& high) {
    m_pivot = (low + high) / 2;
    m_shift.setZero();
    m_radius = std::max((high - low).norm() / 2, 1e-12);
    m_distance = 1.1 * m_radius / std::sin(kFieldOfView / 2);
}

void Camera::fit(const Points3& points, const QSize& viewport) {
    fit(points.rowwise().minCoeff(), points.rowwise().maxCoeff());
    const double aspect = viewport.width() / static_cast<double>(std::max(1, viewport.height()));
    const Mat3 turn = m_turn.toRotationMatrix();
    double distance = 0;
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
        const Vec3 p = turn * (points.col(i) - m_pivot);
        const double across = kMargin / kTanHalf * std::max(std::abs(p.y()), std::abs(p.x()) / aspect);
        distance = std::max(distance, across + (m_orthographic ? 0 : p.z()));
    }
    if (distance > 0) m_distance = distance;
}

Mat3 Camera::axes() const {
    const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
    Mat3 axes;
    switch (m_upAxis) {
        case UpAxis::X:
            axes << y, z, x;
            break;
        case UpAxis::Y:
            axes << x, -z, y;
            break;
        case UpAxis::Z:
            axes << x, y, z;
            break;
    }
    return axes;
}

void Camera::look(Axis axis) {
    m_shift.setZero();
    const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
    const auto along = [this](const Vec3& direction, const Vec3& up) {
        m_turn = turn(axes() * direction, axes() * up);
    };
    switch (axis) {
        case Axis::Front:
            along(y, z);
            break;
        case Axis::Back:
            along(-y, z);
            break;
        case Axis::Right:
            along(-x, z);
            break;
        case Axis::Left:
            along(x, z);
            break;
        case Axis::Top:
            along(-z, y);
            break;
        case Axis::Bottom:
            along(z, y);
            break;
        case Axis::Isometric:
            along(Vec3(-1, 1.4, -0.8), z);
            break;
    }
}

void Camera::setUpAxis(UpAxis axis) {
    const Mat3 before = axes();
    m_upAxis = axis;
    m_turn = (m_turn * Eigen::Quaterniond(Mat3(before * axes().transpose()))).normalized();
}

SavedCamera Camera::saved() const {
    const auto place = [this](const Vec3& p) { return rounded(p, m_distance); };
    SavedCamera kept{
        place(centre() - m_distance * direction()), place(centre()), rounded(up(), 1), {}, m_orthographic};
    if (place(m_pivot) != kept.target) kept.pivot = place(m_pivot);
    return kept;
}

void Camera::restore(const SavedCamera& kept) {
    m_pivot = kept.target;
    m_shift.setZero();
    m_distance = (kept.target - kept.position).norm();
    m_turn = turn(kept.target - kept.position, kept.up);
    m_orthographic = kept.parallel;
    if (kept.pivot) setPivot(*kept.pivot);
}

void Camera::setPivot(const Vec3& pivot) {
    const Vec3 way = pivot - m_pivot;
    m_shift += Eigen::Vector2d(right().dot(way), up().dot(way));
    m_distance = std::max(m_distance + direction().dot(way), 1e-6 * m_radius);
    m_pivot = pivot;
}

void Camera::lookAt(const Vec3& point) {
    m_pivot = point;
    m_shift.setZero();
}

void Camera::lookAlong(const Vec3& direction) {
    const Vec3 way = direction.normalized();
    const Vec3 up = axes().col(2);
    m_turn = turn(way, std::abs(way.dot(up)) > 0.95 ? Vec3(axes().col(1)) : up);
}

Vec3 Camera::centre() const {
    return m_pivot - m_shift.x() * right() - m_shift.y() * up();
}

void Camera::orbit(double dx, double dy) {
    m_turn =
        (Eigen::AngleAxisd(dy, Vec3::UnitX()) * m_turn * Eigen::AngleAxisd(dx, axes().col(2))).normalized();
}

double Camera::pixelSize(const QSize& viewport) const {
    return 2 * m_distance * kTanHalf / std::max(1, viewport.height());
}

double Camera::pixelSize(const QSize& viewport, const Vec3& at) const {
    if (m_orthographic) return pixelSize(viewport);
    const double depth = m_distance + direction().dot(at - m_pivot);
    return pixelSize(viewport) * std::max(depth, 1e-3 * m_distance) / m_distance;
}

void Camera::pan(double dxPixels, double dyPixels, const QSize& viewport) {
    m_pivot += pixelSize(viewport) * (dyPixels * up() - dxPixels * right());
}

void Camera::zoom(double factor, const Eigen::Vector2d& pixel, const QSize& viewport) {
    const Eigen::Vector2d offset = pixel - Eigen::Vector2d(viewport.width(), viewport.height()) / 2;
    const double before = pixelSize(viewport);
    m_distance = std::clamp(m_distance / factor, 1e-4 * m_radius, 1e3 * m_radius);
    const double shift = before - pixelSize(viewport);
    m_pivot += shift * (offset.x() * right() - offset.y() * up());
}

Eigen::Matrix4d Camera::view() const {
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
    matrix.topLeftCorner<3, 3>() = m_turn.toRotationMatrix();
    matrix.topRightCorner<3, 1>() = m_turn * -centre() - Vec3(0, 0, m_distance);
    return matrix;
}

Eigen::Matrix4d Camera::projection(const QSize& viewport) const {
    const double aspect = viewport.width() / static_cast<double>(std::max(1, viewport.height()));
    const double far = m_distance + 4 * m_radius,
                 near = std::max(m_distance - 4 * m_radius, 1e-3 * m_distance);
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
    if (m_orthographic) {
        const double half = m_distance * kTanHalf, front = m_distance - 4 * m_radius;
        matrix.diagonal() << 1 / (half * aspect), 1 / half, -2 / (far - front), 1;
        matrix(2, 3) = -(far + front) / (far - front);
        return matrix;
    }
    matrix(0, 0) = 1 / (kTanHalf * aspect);
    matrix(1, 1) = 1 / kTanHalf;
    matrix(2, 2) = -(far + near) / (far - near);
    matrix(2, 3) = -2 * far * near / (far - near);
    matrix(3, 2) = -1;
    return matrix;
}

Ray Camera::ray(const Eigen::Vector2d& pixel, const QSize& viewport) const {
    const Eigen::Vector2d offset = pixel - Eigen::Vector2d(viewport.width(), viewport.height()) / 2;
    const Vec3 onPivotPlane = centre() + pixelSize(viewport) * (offset.x() * right() - offset.y() * up());
    const Vec3 eye = centre() - m_distance * direction();
    if (m_orthographic) return {onPivotPlane - (m_distance + 4 * m_radius) * direction(), direction()};
    return {eye, (onPivotPlane - eye).normalized()};
}

Vec3 Camera::project(const Vec3& p, const QSize& viewport) const {
    const Eigen::Vector4d clip = projection(viewport) * view() * p.homogeneous();
    const Vec3 device = clip.head<3>() / clip.w();
    return {(device.x() + 1) / 2 * viewport.width(), (1 - device.y()) / 2 * viewport.height(), device.z()};
}

Navigation::Drag Navigation::dragFor(const QMouseEvent& event) const {
    const bool shift = event.modifiers() & Qt::ShiftModifier,
               control = event.modifiers() & Qt::ControlModifier, alt = event.modifiers() & Qt::AltModifier;
    const auto button = event.button();
    if (m_preset == NavigationPreset::VtkLike) {
        if (button == Qt::LeftButton) return shift ? Drag::Pan : Drag::Orbit;
        if (button == Qt::MiddleButton) return Drag::Pan;
        return button == Qt::RightButton ? Drag::Zoom : Drag::None;
    }
    const bool right = m_preset == NavigationPreset::Wend && button == Qt::RightButton;
    // Alt with the left button replaces a missing middle button.
    if (button != Qt::MiddleButton && !right && !(alt && button == Qt::LeftButton)) return Drag::None;
    if (shift) return Drag::Pan;
    return control ? Drag::Zoom : Drag::Orbit;
}

bool Navigation::isClick(const QMouseEvent& event) const {
    return (event.position() - m_pressed).manhattanLength() <= kClickPixels;
}

void Navigation::press(const QMouseEvent& event) {
    m_last = m_pressed = event.position();
    m_drag = dragFor(event);
}

void Navigation::pressToPan(const QMouseEvent& event) {
    press(event);
    m_drag = Drag::Pan;
}

void Navigation::move(const QMouseEvent& event, Camera& camera, const QSize& view) {
    const QPointF step = event.position() - std::exchange(m_last, event.position());
    if (m_drag == Drag::Orbit) camera.orbit(step.x() * kRadiansPerPixel, step.y() * kRadiansPerPixel);
    if (m_drag == Drag::Pan) camera.pan(step.x(), step.y(), view);
    if (m_drag == Drag::Zoom)
        camera.zoom(std::exp(-0.01 * step.y()), {view.width() / 2.0, view.height() / 2.0}, view);
}

}  // namespace wend
