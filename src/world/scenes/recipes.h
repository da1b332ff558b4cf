/// @file
/// The recipes that have a file of their own.
#pragma once

#include "world/scene_recipes.h"

namespace cellsweep {

SceneRecipe level_recipe();
SceneRecipe bullets_recipe();
SceneRecipe swarm_recipe();
SceneRecipe sleepers_recipe();
SceneRecipe dust_recipe();
SceneRecipe axis_recipe();

}  // namespace cellsweep
