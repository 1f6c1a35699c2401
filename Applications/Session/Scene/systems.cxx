#include "systems.h"

#include "own_systems.h"
#include "parameters.h"

#include "vtkOversketchSystem.h"

#ifdef OVERSKETCH_WITH_AUGMENT
#include "vtkOversketchAugment.h"
#endif
#ifdef OVERSKETCH_WITH_EDIT
#include "vtkOversketchEdit.h"
#endif
#ifdef OVERSKETCH_WITH_INFLATEDRAWING
#include "vtkOversketchInflate.h"
#include "vtkOversketchInflateDrawing.h"
#include "vtkOversketchPlanarRefine.h"
#endif
#ifdef OVERSKETCH_WITH_ONESTROKE
#include "vtkOversketchOneStroke.h"
#endif
#ifdef OVERSKETCH_WITH_STELLAR
#include "vtkOversketchTerrain.h"
#endif

namespace oversketch_session
{

namespace
{

#ifdef OVERSKETCH_WITH_ONESTROKE
SystemRow oneStroke()
{
  using System = vtkOversketchOneStroke;
  using Kind = SystemInput::Kind;
  SystemRow row;
  row.name = "OneStroke";
  row.verb = "one-stroke";
  row.title = "Stroke";
  row.brief = "deform a mesh by one stroke";
  row.help =
    "Moves the part of the silhouette that the stroke was drawn beside onto the stroke, and the limb "
    "with it.";
  row.make = make<System>;
  row.inputs = { { "Mesh", "mesh", "the mesh that is deformed", Kind::Mesh, 0 },
    { "Stroke", "stroke", "one polyline in pixels, with the view that it was drawn in", Kind::Stroke, 1 } };
  row.parameters = {
    parameter<System>(PROPERTY(System, Remesh),
      "remesh",
      "Remesh",
      "remesh the region before and after; auto does so where the deformation needs it",
      { { "auto", "where needed" }, { "on", "always" }, { "off", "never" } }),
    parameter<System>(PROPERTY(System, AdjustNormals),
      "adjust-normals",
      "Details turn with the limb",
      "let details turn with the limb (slower)"),
    between(1,
      99,
      parameter<System>(PROPERTY(System, Candidate),
        "candidate",
        "Other outline",
        "which of the sections that fit the stroke is taken, 1 for the best")),
    between(-1,
      1,
      parameter<System>(PROPERTY(System, Reach),
        "reach",
        "Reach into the body",
        "how much further than found the region goes, in lengths of the section; less far where negative")),
    parameter<System>(
      PROPERTY(System, AllowTorn), "allow-torn", "Even if it tears", "hand over a result that is torn, too"),
    parameter<System>(PROPERTY(System, AsPublished),
      "as-published",
      "Paper's method",
      "without the amendments to the published method"),
  };
  row.mirroring = Mirroring::Partners;
  row.keepingPoints = { { "Remesh", int(System::RemeshOff) } };
  row.moves = true;
  row.leftOut = { { "CorrectOutline", "one of the amendments that AsPublished turns off together" } };
  return row;
}
#endif

#ifdef OVERSKETCH_WITH_AUGMENT
SystemRow augment()
{
  using System = vtkOversketchAugment;
  using Kind = SystemInput::Kind;
  SystemRow row;
  row.name = "Augment";
  row.verb = "augment";
  row.title = "Line";
  row.brief = "raise or carve lines on a mesh, finer there";
  row.help =
    "Makes the mesh finer round strokes that were drawn over it and nowhere else, moves its edges onto them, "
    "and raises or carves it there, or pulls a stretch of its outline onto the stroke. Lengths are those of "
    "the model, or with % a share of the diagonal of its box.";
  row.make = make<System>;
  row.inputs = { { "Mesh", "mesh", "the mesh that is drawn on", Kind::Mesh, 0 },
    { "Strokes",
      "strokes",
      "polylines in pixels, each with its view, and with a radius, height and sharpness of its own where it "
      "has these arrays",
      Kind::Stroke,
      1 } };
  row.parameters = {
    length(parameter<System>(PROPERTY(System, Radius),
      "radius",
      "Radius",
      "how far from the stroke the feature ends, below 0 for 3% of the mesh's size")),
    length(parameter<System>(PROPERTY(System, Height),
      "height",
      "Height",
      "height of the feature under the stroke, inward below 0; 0 for half the radius")),
    between(0,
      8,
      parameter<System>(PROPERTY(System, Sharpness),
        "sharpness",
        "Sharpness",
        "exponent s of the profile (1 - distance / radius)^s")),
    parameter<System>(PROPERTY(System, Profile),
      "profile",
      "Profile",
      "the profile as a line instead, such as \"0 1, 0.5 0.8, 1 0\": share of the radius, share of the "
      "height"),
    parameter<System>(PROPERTY(System, UsePressure),
      "use-pressure",
      "Pressure is height",
      "multiply the height by the pen's pressure"),
    later(length(parameter<System>(PROPERTY(System, Taper),
      "taper",
      "Ends taper over",
      "how long a stroke's ends run out into points; 0 for round ends"))),
    parameter<System>(PROPERTY(System, SketchMode),
      "sketch",
      "Strokes are",
      "whether strokes lie on the surface, or are the new outline of what they were drawn beside",
      { { "surface", "on the surface" }, { "silhouette", "a new outline" } }),
    parameter<System>(PROPERTY(System, Combine),
      "combine",
      "Where strokes meet",
      "where several strokes reach a place, the nearest alone or the sum of all",
      { { "nearest", "the nearest alone" }, { "sum", "the sum" } }),
    parameter<System>(PROPERTY(System, Distance),
      "distance",
      "Distances",
      "distances through space, or over the surface, which do not reach round thin parts",
      { { "straight", "through space" }, { "geodesic", "over the surface" } }),
    parameter<System>(PROPERTY(System, Base),
      "base",
      "New triangles follow",
      "what strokes refine: the mesh itself, or a coarser one whose new points lie on the mesh",
      { { "direct", "this mesh" }, { "simplified", "a coarser mesh" } }),
    length(parameter<System>(PROPERTY(System, TargetEdgeLength),
      "edge-length",
      "Longest edge",
      "split longer edges near strokes; 0 for a quarter of the radius, an eighth with a sharpness below 1 or "
      "above 2")),
    parameter<System>(PROPERTY(System, OneByOne),
      "one-by-one",
      "One after the other",
      "draw each stroke on what the one before has made, but for those that neither cross nor lie on each "
      "other"),
    parameter<System>(PROPERTY(System, Simplify),
      "simplify",
      "Take away needless triangles",
      "take away what of the refinement the mesh does not need"),
    parameter<System>(PROPERTY(System, AsPublished),
      "as-published",
      "Paper's method",
      "without the amendments to the published method"),
  };
  row.mirroring = Mirroring::Strokes;
  row.previewsEdits = true;
  return row;
}
#endif

#ifdef OVERSKETCH_WITH_EDIT
SystemRow edit()
{
  using System = vtkOversketchEdit;
  using Kind = SystemInput::Kind;
  SystemRow row;
  row.name = "Edit";
  row.verb = "edit";
  row.title = "Edit";
  row.brief = "move a line on a mesh, or draw its cross-section anew, and what a ring encloses with it";
  row.help =
    "What lies between a line on the mesh and a ring round it follows the line, by grey layers less and less "
    "towards the ring, when it is moved, turned, scaled or dragged; or it follows a cross-section that is "
    "drawn anew. The first stroke of the line, the ring and the cross-section draws it, each further one "
    "redraws a part. Lengths are those of the model, or with % a share of the diagonal of its box. AXIS is "
    "t, "
    "along the line, w, beside it, or n, outward; T is a share of the line's length, 0 to 1.";
  row.make = make<System>;
  SystemInput reference{
    "Reference", "reference", "the line: polylines in pixels, each with its view", Kind::Stroke, 1
  };
  SystemInput boundary{ "Boundary", "boundary", "the ring round it, alike", Kind::Stroke, 2 };
  reference.byOption = boundary.byOption = true;
  SystemInput profile{ "Profile",
    "profile",
    "the cross-section at a place of the line, drawn anew: polylines in its plane, from ring to ring (0 to "
    "1), "
    "outward up, or in pixels with a view onto that; or the places of one as a text, such as \"0 0, 0.4 0.3, "
    "1 0\"",
    Kind::Stroke,
    3,
    true };
  profile.orNumbers = true;
  row.inputs = { { "Mesh", "mesh", "the mesh that is edited", Kind::Mesh, 0 },
    reference,
    boundary,
    profile,
    { "Areas",
      "areas",
      "strokes round areas of the disc, x and y from -1 to 1, that have layers of their own",
      Kind::Stroke,
      4,
      true },
    { "Weights",
      "weights",
      "an image on the disc, white where it follows, black where it stays; it takes the place of layers",
      Kind::Picture,
      5,
      true },
    { "Handles",
      "handles",
      "further handles: points with arrays CurveT and Matrix; of a profile, how far it reaches",
      Kind::Curves,
      6,
      true } };
  row.parameters = {
    offering({ { "", "nothing" } },
      parameter<System>(PROPERTY(System, Operations),
        "operations",
        "What is done",
        "what is done to the line, such as \"move 0.5 n 0.1; rotate 0.7 t 30; pin 0.2; drag 12 -5\"")),
    actingWith("Profile",
      between(0,
        1,
        parameter<System>(PROPERTY(System, ProfileAt),
          "at",
          "Cross-section at",
          "where the cross-section is, a share of the line's length"))),
    between(2,
      16,
      parameter<System>(PROPERTY(System, Levels), "levels", "Grey levels", "how many grey levels there are")),
    fromFile(parameter<System>(PROPERTY(System, Layers),
      "layers",
      "Layers",
      "levels, handles on layers, and areas: { \"levels\": 5, \"handles\": [[0.4, 0.2]], \"areas\": "
      "[{ \"stroke\": \"area.vtp\", \"levels\": 9, \"handles\": [] }] }; a handle is taken from one share of "
      "the way from line to ring to another")),
    parameter<System>(PROPERTY(System, Falloff),
      "falloff",
      "Falls off",
      "how weights fall from line to ring",
      { { "smooth", "smoothly" }, { "linear", "evenly" } }),
    actingWith("Profile",
      parameter<System>(PROPERTY(System, UseTexture),
        "use-texture",
        "Layers weigh the cross-section",
        "multiply what a cross-section does by the layers, too")),
    actingWith("Areas",
      between(0,
        1,
        parameter<System>(PROPERTY(System, Feather),
          "feather",
          "Areas blend over",
          "how far inside its border an area blends with what is round it, a share of the disc's radius"))),
    parameter<System>(PROPERTY(System, Rule),
      "rule",
      "Remesh",
      "new triangles by what the edit does, by curvature, or none",
      { { "edit", "by the edit" }, { "curvature", "by curvature" }, { "off", "none" } }),
    parameter<System>(PROPERTY(System, AsPublished),
      "as-published",
      "Paper's method",
      "without the amendments to the published method"),
  };
  row.phrases = {
    { "move",
      "Operations",
      "T,AXIS,LENGTH",
      "move the line there along the axis; may be given again, as the next three" },
    { "rotate", "Operations", "T,AXIS,DEGREES", "turn it there about the axis, by less than 180 degrees" },
    { "scale", "Operations", "T,AXIS,FACTOR", "scale it there along the axis, by a factor above 0" },
    { "pin", "Operations", "T", "leave it there, and what its neighbours do ends there" },
    { "drag", "Operations", "DX,DY", "move all of the line to the right and up in its view [px]" },
  };
  row.mirroring = Mirroring::TwoRuns;
  row.moves = true;
  row.previewsEdits = true;
  return row;
}
#endif

#ifdef OVERSKETCH_WITH_INFLATEDRAWING
SystemRow inflateDrawing()
{
  using System = vtkOversketchInflateDrawing;
  using Kind = SystemInput::Kind;
  SystemRow row;
  row.name = "InflateDrawing";
  row.verb = "inflate";
  row.title = "Drawing";
  row.brief = "make a model of a drawing, and of the picture under it";
  row.help =
    "Makes a mesh of closed outlines and what is drawn in them, inflates it to both sides or extrudes it, "
    "and lets it wear the picture that it was drawn over.";
  row.make = make<System>;
  SystemInput strokes{ "Strokes",
    "drawing",
    "polylines in pixels, each with its view, drawn over the plane z = 0, and whether it is magnetic, "
    "its inside a hole, and in front or behind where it has these arrays; may be absent with --trace",
    Kind::Stroke,
    0,
    true };
  strokes.madeBy = "Trace";
  row.inputs = { strokes,
    { "Picture", "image", "the picture that was drawn over", Kind::Picture, 1, true },
    { "BackPicture", "back-image", "a picture of the back, as seen from behind", Kind::Picture, 2, true } };
  row.textureInput = "Picture";
  row.backTextureInput = "BackPicture";
  row.backFromRim = "BackFromRim";
  row.skin = true;
  row.parameters = {
    between(0,
      1000,
      parameter<System>(PROPERTY(System, ExtrudeDepth),
        "extrude",
        "Extruded by",
        "extrude so far to either side in place of inflating, in the picture's pixels; 0 inflates")),
    offering({ { "", "circle" }, { "linear", "linear" }, { "step", "step" } },
      parameter<System>(PROPERTY(System, Profile),
        "profile",
        "Cross-section",
        "circle, linear, step, or the cross-section as a line such as \"0 0, 0.3 0.8, 1 1\": share of the "
        "way "
        "from rim to ridge, share of the height")),
    between(0, 5, parameter<System>(PROPERTY(System, Height), "height", "Height", "factor of all heights")),
    parameter<System>(PROPERTY(System, Poisson),
      "poisson",
      "Puffy",
      "inflate by a Poisson equation, rounder and thin limbs thicker"),
    listing(parameter<System>(PROPERTY(System, Holes),
      "hole",
      "Holes",
      "numbers of the strokes, from 0, whose inside is cut out, such as \"2 5\"")),
    listing(parameter<System>(PROPERTY(System, Tunnels),
      "tunnel",
      "Tunnels",
      "numbers of the strokes whose inside is cut out of the finished surface")),
    later(listing(parameter<System>(PROPERTY(System, InFront),
      "in-front",
      "In front",
      "numbers of the closed strokes that bound bodies in front of what was drawn before them"))),
    later(listing(parameter<System>(PROPERTY(System, Behind),
      "behind",
      "Behind",
      "numbers of the closed strokes that bound bodies behind it"))),
    later(listing(parameter<System>(PROPERTY(System, BothSides),
      "both-sides",
      "On both sides",
      "numbers of the closed strokes that bound bodies in front of it and behind"))),
    later(listing(parameter<System>(PROPERTY(System, Trace),
      "trace",
      "Traced",
      "trace the outline of what is at X,Y of the picture, px from its lower left corner, with its holes as "
      "tunnels; auto for its largest thing; outlines come before the strokes"))),
    actingWith("Picture",
      parameter<System>(PROPERTY(System, Magnetic),
        "magnetic",
        "Snap all lines to edges",
        "move every stroke to the picture's edges beside it")),
    parameter<System>(PROPERTY(System, Quads), "quads", "Quads", "make a mesh of quads"),
    between(
      0, 7, parameter<System>(PROPERTY(System, Levels), "levels", "Levels", "how often the mesh is refined")),
    ofStep<vtkOversketchPlanarRefine>("Refine",
      PROPERTY(vtkOversketchPlanarRefine, LevelsFromSketch),
      "levels-from-sketch",
      "Levels from the sketch",
      "refine until edges are shorter than a fiftieth of the canvas, whatever the levels"),
    ofStep<vtkOversketchInflate>("Inflate",
      PROPERTY(vtkOversketchInflate, UnstretchedRims),
      "unstretched-rims",
      "Even triangles at rims",
      "move vertices near rims, so that triangles there are not stretched by their height"),
    parameter<System>(PROPERTY(System, Arrange),
      "arrange",
      "Strokes may cross",
      "let strokes cross each other, span what they lie in, and bound an object together"),
    parameter<System>(PROPERTY(System, AsPublished),
      "as-published",
      "Paper's method",
      "without the amendments to the published method"),
    later(actingWith("Picture",
      parameter<System>(PROPERTY(System, BackFromRim),
        "back-from-rim",
        "Back from the rim's colours",
        "fill the back with the colours that the picture has at the rim; a picture of the back goes "
        "before"))),
  };
  return row;
}
#endif

#ifdef OVERSKETCH_WITH_STELLAR
SystemRow terrain()
{
  using System = vtkOversketchTerrain;
  SystemRow row;
  row.name = "Terrain";
  row.verb = "terrain";
  row.title = "Terrain";
  row.brief = "make a coarse terrain of a grid of heights";
  row.help =
    "Makes a grid of quads, each two triangles, at the heights that the file tells. It keeps the heights, "
    "and "
    "finer triangles, where it is drawn on, take theirs from them; in a .vtp file it keeps them, too.";
  row.make = make<System>;
  row.inputs = {
    { "Heights", "heights", "a grid of heights, gray or numbers", SystemInput::Kind::Heights, 0 }
  };
  row.parameters = {
    between(0,
      4096,
      parameter<System>(PROPERTY(System, Columns),
        "columns",
        "Quads along x",
        "quads along x; 0 for 64 along the longer side, or so many that quads are square")),
    between(0,
      4096,
      parameter<System>(PROPERTY(System, Rows), "rows", "Quads along y", "quads along y; 0 as along x")),
    parameter<System>(PROPERTY(System, QuadX),
      "quad-x",
      "Side along x",
      "side of a quad along x; 0 for as long as the grid is"),
    parameter<System>(PROPERTY(System, QuadY),
      "quad-y",
      "Side along y",
      "side of a quad along y; 0 for as long as the grid is"),
    parameter<System>(PROPERTY(System, Scale), "scale", "Scale", "height of one unit of gray"),
    parameter<System>(PROPERTY(System, Offset), "offset", "Offset", "height where gray is 0"),
  };
  row.pairs = {
    { "quads",
      "Columns",
      "Rows",
      "quads along x and y, of the second as many as make them square where it is not given; without "
      "this 64 along the longer side" },
    { "spacing",
      "QuadX",
      "QuadY",
      "sides of a quad along x and y, both alike where one is given; without this as long as the grid is" }
  };
  return row;
}
#endif

} // namespace

SystemRow withDefaults(SystemRow row)
{
  const vtkSmartPointer<vtkOversketchSystem> fresh = row.make();
  for (Parameter& one : row.parameters)
  {
    one.initial = one.get(fresh);
  }
  return row;
}

const std::vector<SystemRow>& systems()
{
  static const std::vector<SystemRow> rows = {
#ifdef OVERSKETCH_WITH_ONESTROKE
    withDefaults(oneStroke()),
#endif
#ifdef OVERSKETCH_WITH_AUGMENT
    withDefaults(augment()),
#endif
#ifdef OVERSKETCH_WITH_EDIT
    withDefaults(edit()),
#endif
#ifdef OVERSKETCH_WITH_INFLATEDRAWING
    withDefaults(inflateDrawing()),
#endif
#ifdef OVERSKETCH_WITH_POSE
    withDefaults(pose()),
#endif
#ifdef OVERSKETCH_WITH_RELAX
    withDefaults(relax()),
#endif
#ifdef OVERSKETCH_WITH_MASK
    withDefaults(mask()),
#endif
#ifdef OVERSKETCH_WITH_STELLAR
    withDefaults(terrain()),
#endif
#ifdef OVERSKETCH_WITH_JOIN
    withDefaults(joining()),
#endif
#ifdef OVERSKETCH_WITH_TRANSFORM
    withDefaults(transform()),
#endif
  };
  return rows;
}

} // namespace oversketch_session
