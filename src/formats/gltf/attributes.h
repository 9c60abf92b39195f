#pragma once

#include "formats/gltf/accessor.h"

/// The types in which the attributes of glTF's vertices and instances may be stored.
namespace inkedge::gltf {

// KHR_mesh_quantization included.
inline const Expected anyPosition{
    vec3, {Component::Float, Component::Int8, Component::Uint8, Component::Int16, Component::Uint16}};
inline const Expected anyNormal{vec3, {Component::Float, Component::Int8, Component::Int16}};
inline const Expected anyCoordinates{
    vec2, {Component::Float, Component::Int8, Component::Uint8, Component::Int16, Component::Uint16}};
inline const Expected anyColor{vec4, {Component::Float, Component::Uint8, Component::Uint16}};
inline const Expected anyOpaqueColor{vec3, {Component::Float, Component::Uint8, Component::Uint16}};
inline const Expected anyRotation{vec4, {Component::Float, Component::Int8, Component::Int16}};
inline const Expected anyWeights{vec4, {Component::Float, Component::Uint8, Component::Uint16}};
inline const Expected anyJoints{vec4, {Component::Uint8, Component::Uint16}};
inline const Expected floatVec3{vec3, {Component::Float}};
inline const Expected floatMat4{mat4, {Component::Float}};

}  // namespace inkedge::gltf
