#pragma once

#include <Qt>

namespace tendon::gui {

/// The font of a row's name.
enum class FontStyle { kPlain, kStrong, kMono };

/// The roles, besides Qt's own, that the delegate of a row reads from every model of the window. A
/// model may leave out any of them.
enum RowRole : int {
  kPathRole = Qt::UserRole + 1,  ///< QString: the path of the row's object
  kKindRole,                     ///< int: ItemKind
  kTimeRole,                     ///< QString: the time of day, shown first
  kGlyphRole,                    ///< QString: a letter before the name
  kGlyphMarkRole,                ///< StateMark: a shape before the name, instead of a letter
  kFontStyleRole,                ///< int: FontStyle
  kDetailRole,                   ///< QString: dim text after the name
  kMarkRole,                     ///< StateMark: before the text of a value
  kUnitRole,                     ///< QString: after a number
  kStaleRole,                    ///< bool: grey text
  kStruckRole,                   ///< bool: struck through
  kAccentRole,                   ///< bool: highlighted, because it can be clicked
  kTrailRole,                    ///< QString: dim words at the right edge of a list of one column
  kObjectRole,                   ///< QString: after the name, the path of the object of an action
  kQuietRole,                    ///< bool: a value in dim text
  kProseRole,                    ///< bool: a value in words, not a number
  kSparklineRole,                ///< Sparkline: the recent course of a value
  kLeftRole,                     ///< bool: a value in words, aligned to the left
  kFreshRole,                    ///< bool: a value that has just changed, or the name of a new row
};

}  // namespace tendon::gui
