// Nodes, materials and extensions of glTF documents: read, or named where they are not kept.
#include "colours.h"
#include "made_files.h"
#include "mesh_file.h"
#include "texture.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTriangle.h"

#include <gtest/gtest.h>

#include <map>

using namespace oversketch_files;
using namespace oversketch_files_test;

namespace
{

const char* const oneNode = R"("scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)";

double facing(vtkPolyData* mesh, vtkIdType face)
{
  vtkNew<vtkIdList> ids;
  mesh->GetPolys()->GetCellAtId(face, ids);
  double p[3][3], normal[3], given[3];
  for (int k = 0; k < 3; ++k)
  {
    mesh->GetPoint(ids->GetId(k), p[k]);
  }
  vtkTriangle::ComputeNormal(p[0], p[1], p[2], normal);
  mesh->GetPointData()->GetNormals()->GetTuple(ids->GetId(0), given);
  return normal[0] * given[0] + normal[1] * given[1] + normal[2] * given[2];
}

std::string refusal(const std::string& document)
{
  try
  {
    readText(document);
    return "read";
  }
  catch (const Failed& failed)
  {
    return failed.what();
  }
}

} // namespace

TEST(GltfMirrored, ANodeOfNegativeScaleTurnsItsFaces)
{
  const std::string mesh = R"("meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":1},"mode":6}]}])";
  const std::map<std::string, std::string> nodes = { { "mirrored", R"([{"mesh":0,"scale":[-1,1,1]}])" },
    { "by a matrix", R"([{"mesh":0,"matrix":[1,0,0,0, 0,1,0,0, 0,0,-1,0, 3,4,5,1]}])" },
    { "by its parent", R"([{"children":[1],"scale":[1,-2,1]},{"mesh":0,"rotation":[0,0.6,0,0.8]}])" },
    { "twice, which turns it", R"([{"children":[1],"scale":[-1,1,1]},{"mesh":0,"scale":[1,-1,1]}])" },
    { "not at all", R"([{"mesh":0,"scale":[2,3,4]}])" } };
  for (const auto& [what, list] : nodes)
  {
    const auto read = readText(gltf(R"("scenes":[{"nodes":[0]}],"nodes":)" + list + "," + mesh));
    ASSERT_EQ(read->GetNumberOfPolys(), 2);
    EXPECT_NEAR(facing(read, 0), 1.0, 1e-6) << what;
    EXPECT_NEAR(facing(read, 1), 1.0, 1e-6) << what;
  }
}

TEST(GltfTexture, ItsPlacingIsInTheCoordinates)
{
  const std::string coordinates = bytesOf<float>({ 1, 0, 0, 1, 0, 0, 0.5F, 0.5F }),
                    picture = pictureOfGrey(1);
  const auto placed = [&](const std::string& reference)
  {
    Notes notes;
    return readText(
      gltf(std::string(oneNode) + R"("materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0)" +
             reference + R"(}}}],"textures":[{"source":0}],"images":[{"uri":")" + dataUri(picture) +
             R"("}],"meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":2,"TEXCOORD_1":3},)"
             R"("mode":6,"material":0}]}])",
        coordinates + bytesOf<float>({ 9, 9, 9, 9, 9, 9, 9, 9 }),
        R"(,{"bufferView":2,"componentType":5126,"type":"VEC2","count":4},
                         {"bufferView":2,"byteOffset":32,"componentType":5126,"type":"VEC2","count":4})"),
      "made.gltf",
      notes);
  };
  const auto expectAt = [](vtkPolyData* mesh, vtkIdType at, double u, double v)
  {
    ASSERT_TRUE(mesh->GetPointData()->GetTCoords());
    EXPECT_NEAR(mesh->GetPointData()->GetTCoords()->GetComponent(at, 0), u, 1e-6);
    EXPECT_NEAR(
      mesh->GetPointData()->GetTCoords()->GetComponent(at, 1), 1.0 - v, 1e-6); // glTF counts from the top
  };
  const auto scaled = placed(R"(,"extensions":{"KHR_texture_transform":{"offset":[0.25,0],"scale":[2,3]}})");
  EXPECT_EQ(textureOf(scaled), picture);
  expectAt(scaled, 0, 2.25, 0.0);
  expectAt(scaled, 1, 0.25, 3.0);
  // Against the clock as one looks at it: from the right, u = 1, to the top, v = -1.
  const auto turned = placed(
    R"(,"extensions":{"KHR_texture_transform":{"offset":[0.25,0],"scale":[2,3],"rotation":1.5707963267948966}})");
  expectAt(turned, 0, 0.25, -2.0);
  expectAt(turned, 1, 3.25, 0.0);
  expectAt(placed(R"(,"extensions":{"KHR_texture_transform":{"texCoord":1}})"), 0, 9.0, 9.0);
  expectAt(placed(R"(,"texCoord":1)"), 0, 9.0, 9.0);
  expectAt(placed(""), 0, 1.0, 0.0);
}

TEST(GltfExtensions, ThatAreRequiredAndUnknownAreRefusedByName)
{
  const std::string mesh =
    std::string(oneNode) + R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"mode":6}]}])";
  for (const char* name :
    { "EXT_meshopt_compression", "KHR_draco_mesh_compression", "ACME_shape", "KHR_texture_basisu" })
  {
    const std::string why = refusal(gltf(R"("extensionsRequired":[")" + std::string(name) + R"("],)" + mesh));
    EXPECT_NE(why.find(std::string("requires the glTF extension ") + name), std::string::npos) << why;
  }
  for (const char* name : { "KHR_materials_unlit", "KHR_texture_transform", "KHR_mesh_quantization" })
  {
    EXPECT_EQ(refusal(gltf(R"("extensionsRequired":[")" + std::string(name) + R"("],)" + mesh)), "read")
      << name;
  }
  const std::string draco = refusal(gltf(std::string(oneNode) +
                                           R"("meshes":[{"primitives":[{"attributes":{"POSITION":2},"mode":6,
    "extensions":{"KHR_draco_mesh_compression":{"bufferView":2,"attributes":{"POSITION":0}}}}]}])",
    "",
    R"(,{"componentType":5126,"type":"VEC3","count":4})"));
  EXPECT_NE(draco.find("compressed by the glTF extension KHR_draco_mesh_compression"), std::string::npos)
    << draco;
}

TEST(GltfNotes, SpeakAUsersWords)
{
  Notes notes;
  readText(
    gltf(
      R"("scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"extensionsUsed":["KHR_lights_punctual"],"cameras":[{}],
    "animations":[{}],"materials":[{"doubleSided":true,"normalTexture":{"index":0},"emissiveFactor":[0,0,0]}],
    "meshes":[{"primitives":[{"attributes":{"POSITION":0},"mode":6,"material":0,"targets":[{"POSITION":0}]},
                             {"attributes":{"POSITION":0},"mode":1}]}])"),
    "made.gltf",
    notes);
  for (const char* words : { "its morph targets",
         "its lines and points",
         "its lights",
         "its cameras",
         "its animations",
         "normal maps",
         "both sides" })
  {
    EXPECT_TRUE(isSaid(notes, words)) << words << '\n' << allOf(notes);
  }
  for (const char* raw : { "extensionsUsed", "doubleSided", "normalTexture", "KHR", "glows" })
  {
    EXPECT_FALSE(isSaid(notes, raw)) << raw << '\n' << allOf(notes);
  }
}

TEST(GltfParts, WithoutCoordinatesOrColoursLeaveThoseOfOthersAlone)
{
  Notes notes;
  const auto mesh =
    readText(gltf(std::string(oneNode) +
                    R"("meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":2},"mode":6},
                             {"attributes":{"POSITION":0,"COLOR_0":1},"mode":6}]}])",
               bytesOf<float>({ 1, 0, 0, 1, 0, 0, 0.5F, 0.5F }),
               R"(,{"bufferView":2,"componentType":5126,"type":"VEC2","count":4})"),
      "made.gltf",
      notes);
  ASSERT_TRUE(mesh->GetPointData()->GetTCoords() && coloursOf(mesh));
  EXPECT_EQ(tuple(mesh->GetPointData()->GetTCoords(), 0), (Numbers{ 1.0, 1.0 }));
  EXPECT_TRUE(isNowhere(mesh->GetPointData()->GetTCoords(), 4));
  EXPECT_EQ(tuple(coloursOf(mesh), 0), (Numbers{ 255, 255, 255 })) << "as the standard has it";
  EXPECT_EQ(tuple(coloursOf(mesh), 4), (Numbers{ 0, 0, 255 }));
  EXPECT_FALSE(isSaid(notes, "is dropped")) << allOf(notes);
}
