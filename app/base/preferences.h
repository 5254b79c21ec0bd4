#pragma once

#include <QSettings>
#include <QString>
#include <QStringList>
#include <QVariant>
#include <utility>

namespace wend {

/// A choice of the user that outlives the program. Its key in the settings file is never renamed.
template <class T>
class Preference {
  public:
    explicit Preference(QString key, T standard = {}) : m_key(std::move(key)), m_standard(standard) {}

    /// Returns the standard until something was chosen.
    T value() const { return QSettings().value(m_key, QVariant::fromValue(m_standard)).template value<T>(); }
    bool isSet() const { return QSettings().contains(m_key); }
    void forget() const { QSettings().remove(m_key); }
    void set(const T& value) const { QSettings().setValue(m_key, QVariant::fromValue(value)); }

  private:
    QString m_key;
    T m_standard;
};

/// All of them, but for each section of the panels whether it is unfolded ("open/NAME"), and for each action
/// the keys that the user chose ("keys/MAKER/ACTION").
namespace preferences {

inline const Preference<QString> language{QStringLiteral("language")};      // a code; empty: the desktop's
inline const Preference<int> appearance{QStringLiteral("appearance")};      // Appearance
inline const Preference<double> markSize{QStringLiteral("markSize"), 1};    // of pins, as a factor
inline const Preference<int> backdrop{QStringLiteral("backdrop")};          // its place in the menu
inline const Preference<int> navigation{QStringLiteral("navigation")};      // NavigationPreset
inline const Preference<int> mapOpacity{QStringLiteral("mapOpacity"), 65};  // percent
inline const Preference<bool> mapSmooth{QStringLiteral("mapSmooth")};
inline const Preference<bool> propertiesShown{QStringLiteral("properties"), true};
inline const Preference<bool> rulerInFrames{QStringLiteral("ruler/frames")};
inline const Preference<bool> keyPosesShown{QStringLiteral("ruler/poses"), true};
inline const Preference<bool> soundHeard{QStringLiteral("ruler/sound"), true};
inline const Preference<QString> folder{QStringLiteral("folder")};  // of the last file that was chosen
inline const Preference<QStringList> recentFiles{QStringLiteral("recent")};

}  // namespace preferences

}  // namespace wend
