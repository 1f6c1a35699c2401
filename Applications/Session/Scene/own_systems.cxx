#include "own_systems.h"

#include "parameters.h"

#ifdef OVERSKETCH_WITH_JOIN
#include "vtkOversketchJoin.h"
#endif
#ifdef OVERSKETCH_WITH_MASK
#include "vtkOversketchMask.h"
#endif
#ifdef OVERSKETCH_WITH_POSE
#include "vtkOversketchPose.h"
#endif
#ifdef OVERSKETCH_WITH_RELAX
#include "vtkOversketchRelax.h"
#endif
#ifdef OVERSKETCH_WITH_TRANSFORM
#include "vtkOversketchTransform.h"
#endif

namespace oversketch_session
{

#ifdef OVERSKETCH_WITH_POSE
SystemRow pose()
{
  using System = vtkOversketchPose;
  using Kind = SystemInput::Kind;
  SystemRow row;
  row.name = "Pose";
  row.verb = "pose";
  row.title = "Pose";
  row.brief = "bend a limb with the pen, by a bone drawn along it and the bone's new course";
  row.help =
    "A line along a limb, from the joint that stays to the tip, is its bone; another one from the joint on "
    "says where the bone is to go, in the plane of its picture. What the surface joins to the limb beyond "
    "the joint bends with it. Without the second line the mesh stays as it is.";
  row.make = make<System>;
  SystemInput bone{ "Bone",
    "bone",
    "the bone: a polyline in pixels with its view, from the joint that stays to the limb's tip",
    Kind::Stroke,
    1 };
  bone.byOption = true;
  row.inputs = {
    { "Mesh", "mesh", "the mesh whose limb is bent", Kind::Mesh, 0 },
    bone,
    { "Pose", "pose", "where the bone is to go: a polyline alike, from the joint on", Kind::Stroke, 2, true }
  };
  row.parameters = {
    actingWith("Pose",
      between(0.05,
        20,
        parameter<System>(PROPERTY(System, Softness),
          "softness",
          "Softness",
          "length over which a joint bends, in thicknesses of the limb there"))),
    actingWith("Pose",
      parameter<System>(PROPERTY(System, Stretch),
        "stretch",
        "Stretch",
        "stretch or shorten the limb, so that it ends where the new course does")),
  };
  row.mirroring = Mirroring::TwoRuns;
  row.moves = true;
  return row;
}
#endif

#ifdef OVERSKETCH_WITH_RELAX
SystemRow relax()
{
  using System = vtkOversketchRelax;
  using Kind = SystemInput::Kind;
  SystemRow row;
  row.name = "Relax";
  row.verb = "relax";
  row.title = "Smoothing";
  row.brief = "smooth a mesh along strokes";
  row.help =
    "Relaxes the surface in a band on both sides of strokes that were drawn over it: bumps smaller than the "
    "band go, the shape stays. Lengths are those of the model, or with % a share of the diagonal of its box.";
  row.make = make<System>;
  row.inputs = { { "Mesh", "mesh", "the mesh that is smoothed", Kind::Mesh, 0 },
    { "Strokes",
      "strokes",
      "polylines in pixels, each with its view, and with a radius of its own where it has that array",
      Kind::Stroke,
      1 } };
  row.parameters = {
    length(parameter<System>(PROPERTY(System, Radius),
      "radius",
      "Radius",
      "how far from the stroke the surface is smoothed, below 0 for 3% of the mesh's size")),
    between(0,
      1,
      parameter<System>(
        PROPERTY(System, Strength), "strength", "Strength", "share of the way to the smooth surface")),
    parameter<System>(PROPERTY(System, UsePressure),
      "use-pressure",
      "Pressure is strength",
      "multiply the strength by the pen's pressure"),
    between(0,
      180,
      parameter<System>(PROPERTY(System, FeatureAngle),
        "feature-angle",
        "Keep edges over",
        "points at edges that bend by more degrees stay, 180 for none")),
  };
  row.mirroring = Mirroring::Strokes;
  return row;
}
#endif

#ifdef OVERSKETCH_WITH_MASK
SystemRow mask()
{
  using System = vtkOversketchMask;
  using Kind = SystemInput::Kind;
  SystemRow row;
  row.name = "Mask";
  row.verb = "mask";
  row.title = "Mask";
  row.brief = "mask a part of a mesh, which no step then moves";
  row.help = "Masks the points that lassos enclose in the picture, or frees them; then the mask may grow or "
             "shrink, and "
             "be inverted. It is point array Mask of the mesh, 1 where no step moves a point. Lengths are "
             "those of the "
             "model, or with % a share of the diagonal of its box.";
  row.make = make<System>;
  row.inputs = { { "Mesh", "mesh", "the mesh that is masked", Kind::Mesh, 0 },
    { "Strokes",
      "lasso",
      "polylines in pixels, each with its view, which a straight line closes; none is needed to grow, invert "
      "or clear the mask",
      Kind::Stroke,
      1,
      true } };
  row.parameters = {
    parameter<System>(PROPERTY(System, Mode),
      "mode",
      "What is enclosed",
      "whether what a lasso encloses is masked too, is freed, or alone is masked; replace without a lasso "
      "clears the mask",
      { { "add", "is masked, too" }, { "subtract", "is freed" }, { "replace", "alone is masked" } }),
    actingWith("Strokes",
      parameter<System>(PROPERTY(System, Through),
        "through",
        "Hidden parts, too",
        "take also what is hidden in the picture")),
    length(parameter<System>(
      PROPERTY(System, Grow), "grow", "Grow by", "how far the mask grows over the surface, below 0 shrinks")),
    parameter<System>(
      PROPERTY(System, Invert), "invert", "Invert", "mask what is free and free what is masked, at the end"),
  };
  row.mirroring = Mirroring::Strokes;
  return row;
}
#endif

#ifdef OVERSKETCH_WITH_JOIN
SystemRow joining()
{
  using System = vtkOversketchJoin;
  SystemRow row;
  row.name = "Join";
  row.verb = "join";
  row.title = "Join";
  row.brief = "make one closed body of parts, with a rounded seam; cut one from another; keep what both fill";
  row.help =
    "Joins the closed parts of a mesh (cell array PartId, else the pieces that hang together), and "
    "those of a further mesh where one is given, into one closed body, with a crease or a rounded seam "
    "where they meet. Lengths are those of the model, or with % a share of the diagonal of its box.";
  row.make = make<System>;
  row.inputs = { { "Mesh", "mesh", "the mesh whose parts are joined", SystemInput::Kind::Mesh, 0 },
    { "Other", "with", "a further mesh whose parts come after its own", SystemInput::Kind::Mesh, 1, true } };
  row.parameters = {
    parameter<System>(PROPERTY(System, Operation),
      "operation",
      "Result",
      "what becomes of the parts: one body, the first one without the others, or what all of them fill",
      { { "join", "one body" }, { "cut", "the first without the others" }, { "common", "what all fill" } }),
    length(parameter<System>(PROPERTY(System, Width),
      "width",
      "Seam",
      "how wide the rounded seam is where they meet, 0 for a crease")),
    parameter<System>(PROPERTY(System, Bridge),
      "bridge",
      "Bridge gaps",
      "join parts that do not meet by a bar as thick as the seam is wide"),
  };
  row.joinsParts = true;
  return row;
}
#endif

#ifdef OVERSKETCH_WITH_TRANSFORM
SystemRow transform()
{
  using System = vtkOversketchTransform;
  SystemRow row;
  row.name = "Transform";
  row.verb = "transform";
  row.title = "Place";
  row.brief = "move, turn and scale a mesh or a part of it, or add its mirror image";
  row.help = "Scales, turns and moves the mesh or one of its parts, about the middle of the box of what "
             "moves, and adds its image in a mirror where one is asked for. Lengths are those of the model.";
  row.make = make<System>;
  row.inputs = { { "Mesh", "mesh", "the mesh that is placed", SystemInput::Kind::Mesh, 0 } };
  row.parameters = {
    triple<System>(PROPERTY(System, Move), "move", "Move", "how far along x, y and z"),
    triple<System>(
      PROPERTY(System, Turn), "turn", "Turn", "degrees about x, y and z; y first, then x, then z"),
    oneForAll(triple<System>(PROPERTY(System, Scale),
      "scale",
      "Scale",
      "factors along x, y and z, before it is turned; one number for all three")),
    between(-1,
      1000000,
      parameter<System>(
        PROPERTY(System, Part), "part", "Part", "the part's number, as in cell array PartId; -1 for all")),
    parameter<System>(PROPERTY(System, Copy),
      "copy",
      "Copy",
      "add it once more, as a further part, in the mirror",
      { { "off", "none" }, { "mirrored", "in the mirror" } }),
    parameter<System>(PROPERTY(System, MirrorAxis),
      "mirror-axis",
      "Mirror across",
      "the axis that the copy's mirror is upright on",
      { { "x", "x" }, { "y", "y" }, { "z", "z" } }),
    parameter<System>(
      PROPERTY(System, MirrorOffset), "mirror-offset", "Mirror at", "where the mirror is on that axis"),
  };
  row.addsParts = true;
  return row;
}
#endif

} // namespace oversketch_session
