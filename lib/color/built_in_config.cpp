#include "color/ocio.h"

#include <sstream>

namespace candela {

namespace {

// The scene reference space is ACES2065-1 and the display reference space CIE XYZ with a D65 white, so that
// OpenColorIO's built-in transforms can be used as they are. The first display and its first view are the
// default.
//
// The ACES view's limit is the display's gamut: on Rec.709 displays the output transform for Rec.709, on P3
// displays the one that limits to P3. P3-D65 is a cinema's projector (gamma 2.6, dark room); Display P3 a
// computer's screen, with sRGB's curve. OpenColorIO has no built-in transform for the latter; the matrix is
// the inverse of XYZ from P3 primaries with D65 (SMPTE EG 432-1), the curve that of IEC 61966-2-1.
constexpr const char* text = R"(ocio_profile_version: 2

description: candela's built-in config
environment: {}
search_path: ""
strictparsing: true
luma: [0.2126, 0.7152, 0.0722]

roles:
  aces_interchange: ACES2065-1
  cie_xyz_d65_interchange: CIE-XYZ-D65
  data: Raw
  default: Linear Rec.709
  rendering: Linear Rec.709
  scene_linear: Linear Rec.709

file_rules:
  - !<Rule> {name: Default, colorspace: default}

displays:
  sRGB:
    - !<View> {name: Un-tone-mapped, view_transform: Un-tone-mapped, display_colorspace: sRGB}
    - !<View> {name: ACES 1.0 SDR, view_transform: ACES 1.0 SDR, display_colorspace: sRGB}
    - !<View> {name: Raw, colorspace: Raw}
  Rec.1886:
    - !<View> {name: Un-tone-mapped, view_transform: Un-tone-mapped, display_colorspace: Rec.1886}
    - !<View> {name: ACES 1.0 SDR, view_transform: ACES 1.0 SDR, display_colorspace: Rec.1886}
    - !<View> {name: Raw, colorspace: Raw}
  Display P3:
    - !<View> {name: Un-tone-mapped, view_transform: Un-tone-mapped, display_colorspace: Display P3}
    - !<View>
      name: ACES 1.0 SDR
      view_transform: ACES 1.0 SDR (P3 limited)
      display_colorspace: Display P3
    - !<View> {name: Raw, colorspace: Raw}
  P3-D65:
    - !<View> {name: Un-tone-mapped, view_transform: Un-tone-mapped, display_colorspace: P3-D65}
    - !<View> {name: ACES 1.0 SDR, view_transform: ACES 1.0 SDR (cinema), display_colorspace: P3-D65}
    - !<View> {name: Raw, colorspace: Raw}

default_view_transform: Un-tone-mapped

view_transforms:
  - !<ViewTransform>
    name: Un-tone-mapped
    from_scene_reference: !<BuiltinTransform> {style: UTILITY - ACES-AP0_to_CIE-XYZ-D65_BFD}
  - !<ViewTransform>
    name: ACES 1.0 SDR
    from_scene_reference: !<BuiltinTransform>
      style: ACES-OUTPUT - ACES2065-1_to_CIE-XYZ-D65 - SDR-VIDEO_1.0
  - !<ViewTransform>
    name: ACES 1.0 SDR (P3 limited)
    from_scene_reference: !<BuiltinTransform>
      style: ACES-OUTPUT - ACES2065-1_to_CIE-XYZ-D65 - SDR-VIDEO-P3lim_1.1
  - !<ViewTransform>
    name: ACES 1.0 SDR (cinema)
    from_scene_reference: !<BuiltinTransform>
      style: ACES-OUTPUT - ACES2065-1_to_CIE-XYZ-D65 - SDR-CINEMA_1.0

display_colorspaces:
  - !<ColorSpace>
    name: CIE-XYZ-D65
    description: CIE 1931 XYZ of the display's light, white being D65
    isdata: false
  - !<ColorSpace>
    name: sRGB
    description: Rec.709 primaries, sRGB's curve (IEC 61966-2-1)
    isdata: false
    encoding: sdr-video
    from_display_reference: !<BuiltinTransform> {style: DISPLAY - CIE-XYZ-D65_to_sRGB}
  - !<ColorSpace>
    name: Rec.1886
    description: Rec.709 primaries, gamma 2.4 (ITU-R BT.1886)
    isdata: false
    encoding: sdr-video
    from_display_reference: !<BuiltinTransform> {style: DISPLAY - CIE-XYZ-D65_to_REC.1886-REC.709}
  - !<ColorSpace>
    name: Display P3
    description: P3 primaries, D65 white, sRGB's curve
    isdata: false
    encoding: sdr-video
    from_display_reference: !<GroupTransform>
      children:
        - !<MatrixTransform>
          matrix: [ 2.4934969119414245, -0.9313836179191236, -0.4027107844507168, 0,
                   -0.8294889695615750,  1.7626640603183468,  0.0236246858419436, 0,
                    0.0358458302437843, -0.0761723892680417,  0.9568845240076873, 0,
                    0, 0, 0, 1]
        - !<ExponentWithLinearTransform>
          gamma: [2.4, 2.4, 2.4, 1]
          offset: [0.055, 0.055, 0.055, 0]
          direction: inverse
  - !<ColorSpace>
    name: P3-D65
    description: P3 primaries, D65 white, gamma 2.6
    isdata: false
    encoding: sdr-video
    from_display_reference: !<BuiltinTransform> {style: DISPLAY - CIE-XYZ-D65_to_G2.6-P3-D65}

colorspaces:
  - !<ColorSpace>
    name: ACES2065-1
    description: The ACES archive space, AP0 primaries
    isdata: false
    encoding: scene-linear
  - !<ColorSpace>
    name: ACEScg
    description: AP1 primaries, ACES white
    isdata: false
    encoding: scene-linear
    to_scene_reference: !<BuiltinTransform> {style: ACEScg_to_ACES2065-1}
  - !<ColorSpace>
    name: Linear Rec.709
    aliases: [lin_rec709, Linear Rec.709 (sRGB)]
    description: Rec.709 primaries, D65 white; the working space
    isdata: false
    encoding: scene-linear
    to_scene_reference: !<GroupTransform>
      children:
        - !<BuiltinTransform> {style: UTILITY - ACES-AP1_to_LINEAR-REC709_BFD, direction: inverse}
        - !<BuiltinTransform> {style: ACEScg_to_ACES2065-1}
  - !<ColorSpace>
    name: Raw
    description: The numbers as they are
    isdata: true
    encoding: data
)";

}  // namespace

OCIO::ConstConfigRcPtr builtInConfig() {
    std::istringstream stream(text);
    return OCIO::Config::CreateFromStream(stream);
}

}  // namespace candela
