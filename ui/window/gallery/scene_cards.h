// The cards of the shipped scenes in the gallery: one sentence about what to look for, and the kind
// of its picture. Chapters and titles are those of the scenes. Pure; any thread.
#pragma once

#include <QString>
#include <span>

namespace asperity {

enum class SceneView {
  Contact,  // the line on the elastomer
  CloseUp,  // the contact under the greatest pressure, and what is beside it
  Curve,    // friction over the scene's axis
  Motion    // friction in time
};

struct SceneCard {
  const char* scene;  // name of a shipped scene
  SceneView view;
  const char* sentence;  // what to look for
};

/// Returns one card for each shipped scene.
std::span<const SceneCard> sceneCards();

/// Returns the card of a scene; null where it has none.
const SceneCard* findCard(const QString& scene);

/// Returns the sentence in the language of the window.
QString cardSentence(const SceneCard& card);

}  // namespace asperity
