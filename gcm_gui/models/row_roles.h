#pragma once

#include <Qt>

namespace tendon::gui {

/// How the first text of a row is set.
enum class Face { kPlain, kStrong, kMono };

/// What a row's delegate asks of every model of the window, besides Qt's own roles. All are
/// optional.
enum RowRole : int {
  kPathRole = Qt::UserRole + 1,  ///< QString: what the row stands for
  kKindRole,                     ///< int: ItemKind
  kTimeRole,                     ///< QString: the time of day, before all else
  kGlyphRole,                    ///< QString: a letter before the name
  kGlyphMarkRole,                ///< StateMark: a shape before the name instead
  kFaceRole,                     ///< int: Face
  kDetailRole,                   ///< QString: set dim after the name
  kMarkRole,                     ///< StateMark before the text of a value
  kUnitRole,                     ///< QString after a number
  kStaleRole,                    ///< bool: set grey
  kStruckRole,                   ///< bool: struck through
  kAccentRole,                   ///< bool: asks to be clicked
  kTrailRole,                    ///< QString: dim words at the right edge of a list of one column
  kObjectRole,                   ///< QString: what the name is about, a path; after the name
  kQuietRole,                    ///< bool: a value that is set dim
  kProseRole,                    ///< bool: a value that is words, not a number
  kTrendRole,                    ///< Trend: how a value went
  kLeftRole,                     ///< bool: a value that is words which begin at the left
  kFreshRole,  ///< bool: a value that has just changed, or the name of a row that is new
};

}  // namespace tendon::gui
