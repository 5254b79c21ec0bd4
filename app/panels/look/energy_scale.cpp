#include "app/panels/look/energy_scale.h"

#include <QCoreApplication>
#include <cmath>

#include "core/energy/material.h"

namespace wend {

namespace {

QString said(const char* text) {
    return QCoreApplication::translate("EnergyScale", text);
}

}  // namespace

EnergyScale::EnergyScale(int dimension) : m_dimension(dimension) {
    m_stops[0] = {phi::kEquia, said(QT_TRANSLATE_NOOP("EnergyScale", "Area")),
                  said(QT_TRANSLATE_NOOP("EnergyScale", "Nothing grows or shrinks. Parts may get thin."))};
    m_stops[1] = {phi::kMetr, said(QT_TRANSLATE_NOOP("EnergyScale", "Length")),
                  said(QT_TRANSLATE_NOOP("EnergyScale", "Stretches least. Start here."))};
    m_stops[2] = {phi::kAkvf, said(QT_TRANSLATE_NOOP("EnergyScale", "Rigid")),
                  said(QT_TRANSLATE_NOOP("EnergyScale", "Parts turn like card."))};
    m_stops[3] = {phi::conformal(dimension), said(QT_TRANSLATE_NOOP("EnergyScale", "Angle")),
                  said(QT_TRANSLATE_NOOP("EnergyScale", "Details keep their look. Parts may swell."))};
    if (dimension == 2) return;
    m_stops[0].name = said(QT_TRANSLATE_NOOP("EnergyScale", "Volume"));
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
