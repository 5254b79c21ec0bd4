#include "app/panels/energy_scale.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "core/energy/material.h"

namespace wend {

namespace {

QString said(const char* text) {
    return QCoreApplication::translate("EnergyScale", text);
}

}  // namespace

EnergyScale::EnergyScale(int dimension) : m_dimension(dimension) {
    m_stops[0] = {
        phi::kEquia, said(QT_TRANSLATE_NOOP("EnergyScale", "Area")),
        said(QT_TRANSLATE_NOOP("EnergyScale",
                               "Keeps area: parts neither grow nor shrink. Angles and lengths give way."))};
    m_stops[1] = {phi::kMetr, said(QT_TRANSLATE_NOOP("EnergyScale", "Length")),
                  said(QT_TRANSLATE_NOOP(
                      "EnergyScale",
                      "Keeps lengths best: a balance of area and angle. A good start for most pictures."))};
    m_stops[2] = {phi::kAkvf, said(QT_TRANSLATE_NOOP("EnergyScale", "Rigid")),
                  said(QT_TRANSLATE_NOOP(
                      "EnergyScale", "Turns parts as if they were stiff. Area gives way where parts bend."))};
    m_stops[3] = {
        phi::conformal(dimension), said(QT_TRANSLATE_NOOP("EnergyScale", "Angle")),
        said(QT_TRANSLATE_NOOP(
            "EnergyScale", "Keeps angles: small details keep their form. Parts may grow or shrink a lot."))};
    if (dimension == 2) return;
    m_stops[0].name = said(QT_TRANSLATE_NOOP("EnergyScale", "Volume"));
    m_stops[0].shortHelp = said(QT_TRANSLATE_NOOP(
        "EnergyScale", "Keeps volume: parts neither grow nor shrink. Angles and lengths give way."));
    m_stops[1].shortHelp = said(QT_TRANSLATE_NOOP(
        "EnergyScale", "Keeps lengths best: a balance of volume and angle. A good start for most solids."));
    m_stops[2].shortHelp = said(QT_TRANSLATE_NOOP(
        "EnergyScale", "Turns parts as if they were stiff. Volume gives way where parts bend."));
}

double EnergyScale::phiAt(double position) const {
    return phiAtStop(position, m_dimension);
}

double EnergyScale::positionOf(double phi) const {
    return stopOfPhi(phi, m_dimension);
}

int EnergyScale::stopAt(double phi) const {
    for (int i = 0; i < kStops; ++i)
        if (std::abs(phi - m_stops[i].phi) < 5e-4) return i;
    return -1;
}

}  // namespace wend
