#include <cmath>

#include "tests/example_rows.h"
#include "tests/tools/command_test.h"

namespace tristim {
namespace {

class ShadeCommand : public CommandTest {
 protected:
  static CommandOptions input(const std::string& text) { return {.input = text}; }
};

// Numbers of an answer beside those of an example.
void expect_close(const nlohmann::json& value, const nlohmann::json& expected,
                  const std::string& place) {
  if (expected.is_number()) {
    ASSERT_TRUE(value.is_number()) << place;
    const double number = expected.get<double>();
    EXPECT_NEAR(value.get<double>(), number, 1e-12 * std::fabs(number) + 1e-30) << place;
  } else if (expected.is_structured()) {
    ASSERT_EQ(value.size(), expected.size()) << place;
    for (const auto& [key, part] : expected.items()) {
      const auto& own = value.is_object() ? value.at(key) : value.at(std::stoul(key));
      expect_close(own, part, place + "/" + key);
    }
  } else {
    EXPECT_EQ(value, expected) << place;
  }
}

TEST_F(ShadeCommand, AgreesWithTheExamplesInCsv) {
  if (!shared_dir()) GTEST_SKIP() << kNoShared;
  int tables = 0;
  const std::filesystem::path folder = *shared_dir() / "spec/shade-examples";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".csv") continue;
    ++tables;
    SCOPED_TRACE(entry.path().filename());
    write("out.csv", good({"shade", entry.path().stem().string(), entry.path().string(), "-"}));
    const std::vector<ExampleRow> expected = example_rows(entry.path());
    const std::vector<ExampleRow> rows = example_rows(file("out.csv"));
    ASSERT_EQ(rows.size(), expected.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      for (const std::string& name :
           cells_of(read("out.csv").substr(0, read("out.csv").find('\n')))) {
        const bool id = name == "id";
        const double wanted = expected[i].number(id ? name : "out_" + name);
        EXPECT_NEAR(rows[i].number(name), wanted, 1e-12 * std::fabs(wanted) + 1e-30) << name;
      }
    }
  }
  EXPECT_GE(tables, 18);
}

TEST_F(ShadeCommand, AgreesWithTheExamplesInJson) {
  if (!shared_dir()) GTEST_SKIP() << kNoShared;
  int files = 0;
  const std::filesystem::path folder = *shared_dir() / "spec/shade-examples";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".json") continue;
    ++files;
    SCOPED_TRACE(entry.path().filename());
    const auto expected = parsed(read_bytes(entry.path()));
    const auto answers =
        parsed(good({"shade", entry.path().stem().string(), entry.path().string(), "-"}));
    ASSERT_EQ(answers.size(), expected.size());
    for (std::size_t i = 0; i < answers.size(); ++i) {
      EXPECT_GE(answers[i].size(), 2U);
      for (const auto& [key, value] : answers[i].items()) {
        expect_close(value, expected[i].at(key), key);
      }
    }
  }
  EXPECT_GE(files, 10);
}

TEST_F(ShadeCommand, ReadsColumnsInAnyOrderAndFromOptions) {
  const std::string rows = "unused,eta_t,id,cos_i\r\n9,1.5,b,1\r\n\r\n# a comment\nx, 1 ,a,0.5\n";
  EXPECT_EQ(good("shade fresnel_dielectric - - --eta_i 1", input(rows)), "id,F\nb,0.04\na,0\n");
  EXPECT_EQ(good("shade fresnel_dielectric --cos_i 1 --eta_i 1 --eta_t 1.5"), "F\n0.04\n");
  EXPECT_EQ(good("shade attenuation - --kind Inverse-Square --c1 0 --c2 0 --c3 0",
                 input("d,id\n0,\"a,\"\"b\"\n2,c\n")),
            "id,f\n\"a,\"\"b\",inf\nc,0.25\n");
  // An option stands for the column even where the file has it.
  EXPECT_EQ(good("shade f0_eta - --eta 1.5", input("eta\n3\n")), "F0,eta_from_F0\n0.04,1.5\n");
}

TEST_F(ShadeCommand, WritesFilesWhole) {
  write("in.csv", "cos_i,eta_i,eta_t\n1,1,1.5\n");
  EXPECT_EQ(good("shade fresnel_dielectric in.csv out.csv"), "");
  EXPECT_EQ(read("out.csv"), "F\n0.04\n");
  refuses("shade fresnel_dielectric in.csv out.csv", 1,
          "out.csv: exists already; give --force to replace it");
  good("shade fresnel_dielectric in.csv out.csv --force");
  refuses("shade fresnel_dielectric in.csv in.csv --force", 2,
          "in.csv: is an input too; choose another name for the output");
  refuses("shade fresnel_dielectric no.csv x.csv", 1,
          "no.csv: cannot be opened: no such file or directory; check the path");
}

TEST_F(ShadeCommand, RefusesUnknownNamesWithAHint) {
  refuses("shade fresnel_dielectrik in.csv", 2,
          "fresnel_dielectrik: unknown model; did you mean fresnel_dielectric?");
  refuses("shade", 2,
          "shade: MODEL is missing; use: tristim shade MODEL in.csv out.csv, or --list");
  refuses("shade f0_eta - --etta 1", 2, "--etta: unknown option; did you mean --eta?",
          input("eta\n1\n"));
  refuses("shade f0_eta -", 3,
          "standard input: column eta is missing for f0_eta; add it or give --eta (the header has "
          "etta)",
          input("id,etta\n1,2\n"));
  refuses("shade f0_eta", 2, "f0_eta: column eta is missing; give a CSV file, or --eta");
}

TEST_F(ShadeCommand, TellsTheRowOfAMistake) {
  const auto row = [](const std::string& wrong) {
    return "standard input, row 2 (line 3)" + wrong;
  };
  refuses("shade f0_eta -", 3, row(": has 2 values, the header names 1; give each column a value"),
          input("eta\n1\n1,2\n"));
  refuses("shade f0_eta -", 3, row(", column eta: 'x' is no number; give above 0"),
          input("eta\n1\nx\n"));
  refuses("shade f0_eta -", 3, row(", column eta: 0 is out of range; give above 0"),
          input("eta\n1\n0\n"));
  refuses("shade microfacet_D - --cos_beta 1", 3,
          row(", column m: 0 is out of range; give above 0"), input("m\n1\n0\n"));
  refuses("shade spot - --cutoff_deg 30 --lpx 1 --lpy 1 --lpz 1 --axisx 1 --axisy 0 --axisz 0", 3,
          row(", column exponent: -1 is out of range; give 0 or more"), input("exponent\n1\n-1\n"));
  refuses("shade attenuation - --d 1 --c1 1 --c2 1 --c3 1", 3,
          row(": column kind: unknown kind 'liner'; did you mean linear?"),
          input("kind\nlinear\nliner\n"));
  refuses("shade f0_eta -", 3,
          "standard input: has no header row; name the columns in the first row", input("\n"));
}

TEST_F(ShadeCommand, TellsTheObjectOfAMistake) {
  refuses("shade area_light -", 3,
          "standard input, object 2 (area_light): 'normal' is missing; add it or give --normal",
          input(R"([{"polygon":[],"point":[0,0,0],"normal":[0,0,1],"Le":1},
                    {"polygon":[],"point":[0,0,0],"Le":1}])"));
  refuses("shade area_light -", 3,
          "standard input, object 1 (area_light): 'polygon[1]' has 2 numbers; give 3",
          input(R"({"polygon":[[1,2,3],[1,2]],"point":[0,0,0],"normal":[0,0,1],"Le":1})"));
  refuses("shade area_light -", 3,
          "standard input: is no JSON list of objects; write [{ ... }, { ... }]", input("[{]"));
  EXPECT_EQ(good("shade area_light - --Le 4 --point [0,0,0]",
                 input(R"({"id": "x", "polygon": [], "normal": [0,0,1]})")),
            "[\n{\"id\":\"x\",\"expect\":{\"E\":0.0,\"form_factor\":0.0}}\n]\n");
}

TEST_F(ShadeCommand, ListsEveryModelWithItsSource) {
  const auto list = parsed(good("shade --list --json"));
  EXPECT_GE(list.size(), 29U);
  for (const auto& model : list) {
    SCOPED_TRACE(model["model"].get<std::string>());
    EXPECT_FALSE(model["inputs"].empty());
    EXPECT_FALSE(model["outputs"].empty());
    EXPECT_FALSE(model["formula"].get<std::string>().empty());
    EXPECT_TRUE(model["source"].get<std::string>().starts_with("["));
    EXPECT_NE(good("shade --list").find(model["model"].get<std::string>()), std::string::npos);
  }
  const std::string help = good("shade spot --help");
  EXPECT_NE(help.find("--cutoff_deg"), std::string::npos);
  EXPECT_NE(help.find("[OpenGL 2.13.1]"), std::string::npos);
}

// N (C14), and a light that moves with the camera (B7): all else is the same for all rows.
TEST_F(ShadeCommand, FarLightsAndCamerasAreOptions) {
  const std::string far =
      "shade local_illumination - --Lx 0 --Ly 0 --Lz 1 --Vx 0 --Vy 0 --Vz 1 --n 2 --ka 0 --kd 1 "
      "--ks 1 --Iar 0 --Iag 0 --Iab 0 --Ipr 1 --Ipg 1 --Ipb 1 --Odr 1 --Odg 0.5 --Odb 0 --Osr 1 "
      "--Osg 1 --Osb 1 --fatt 1";
  EXPECT_EQ(good(far, input("Nx,Ny,Nz\n0,0,1\n0,0,-1\n")),
            "lambert,spec_phong,spec_blinn,I_phongr,I_phongg,I_phongb,I_blinnr,I_blinng,I_blinnb\n"
            "1,1,1,2,1.5,1,2,1.5,1\n0,0,0,0,0,0,0,0,0\n");
  const std::string camera =
      "shade camera_light - --eyex 10 --eyey 20 --eyez 30 --rightx 0 --righty 0 --rightz -1 "
      "--upx 0 --upy 1 --upz 0 --backx 1 --backy 0 --backz 0 --directionx 0 --directiony 0 "
      "--directionz -1";
  EXPECT_EQ(good(camera, input("positionx,positiony,positionz\n0,0,0\n1,2,3\n")),
            "positionx,positiony,positionz,directionx,directiony,directionz\n"
            "10,20,30,-1,0,0\n13,22,29,-1,0,0\n");
}

TEST_F(ShadeCommand, MatchesExponents) {
  const auto row = [](const std::string& out) { return out.substr(out.find('\n') + 1); };
  // [FisherWoo, table 3], and the deviation that its text gives for r = 40
  const auto extremes = [&](const std::string& columns) {
    return cells_of(row(good("shade highlight_extremes --f 4 " + columns)));
  };
  EXPECT_NEAR(std::stod(extremes("--r 10 --LE_deg 90").at(2)), 63.75, 1e-9);
  EXPECT_NEAR(std::stod(extremes("--r 10 --LE_deg 0").at(2)), -3.63, 0.005);
  EXPECT_NEAR(std::stod(extremes("--r 40 --LE_deg 120").at(4)), 7.75, 0.005);
  EXPECT_EQ(row(good("shade coplanar_error --rho_deg 60 --r 5")).substr(0, 5), "6.391");
  EXPECT_EQ(row(good("shade highlight_aside --nu_deg 0 --beta_deg 45 --theta_deg 90")), "1\n");
  EXPECT_EQ(row(good("shade highlight_zero --NdotH 1 --f 4 --LE_deg 90")), "1,0\n");
  EXPECT_EQ(row(good("shade highlight_zero --NdotH 0.5 --f 4 --LE_deg 10")), "0,0\n");
  EXPECT_NEAR(std::stod(row(good("shade highlight_minimax --r 1e9 --LE_deg 90"))), 2.8284271, 1e-6);
  EXPECT_EQ(row(good("shade blinn_match --blinn_n 40 --f 4")).substr(0, 23),
            "10,0.21821789023599236,");
  // The eye at 5 radii; the search finds the extreme to 1e-3.
  EXPECT_NEAR(std::stod(row(good("shade highlight_near_eye --r 10 --f 4 --LE_deg 90 "
                                 "--eye_distance 5"))),
              78.013, 2e-3);
  EXPECT_TRUE(
      row(good("shade exponent_conversion --phong_r 0 --LE_deg 90")).starts_with("0,0,1,1,"));
  refuses("shade exponent_conversion --phong_r -1 --LE_deg 90", 3,
          "options, column phong_r: -1 is out of range; give 0 or more");
}

TEST_F(ShadeCommand, TeachesRasterization) {
  const auto answer = [&](const std::string& model, const std::string& object) {
    return parsed(good("shade " + model + " -", input(object)))[0]["expect"];
  };
  const auto rows =
      answer("scanline", R"({"size":[4,4],"polygon":[[0,0],[4,0],[0,4]],"I":[0,1,0]})");
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[1]["u"], 0.625);
  EXPECT_EQ(rows[1]["I"], nlohmann::json({0.125, 0.375}));
  EXPECT_LE(answer("gouraud_drift", R"({"xQ":0,"xR":999,"IQ":0,"IR":1})")["drift"], 1e-4);
  EXPECT_EQ(answer("normal_incremental", R"({"xQ":0,"xR":2,"NQ":[1,0,0],"NR":[-1,0,2]})")[1],
            nlohmann::json({0, 0, 1}));
  EXPECT_EQ(answer("bounding_box", R"({"size":[32,32],"polygon":[[2,2],[10,2],[2,10]]})"),
            nlohmann::json({2, 2, 10, 10}));
  EXPECT_EQ(
      answer("outline_fill", R"({"size":[3,3],"polygon":[[-1,1],[3,1]],"seed":[0,0]})")["conn4"][0],
      "222");
  const auto gap = answer("t_junctions", R"({"vertices":[[0,0,0],[2,0,0],[1,2,0],[1,0,0],[0,-1,0]],
                                            "faces":[[0,1,2],[4,3,0]],"I":[0,1,0,0.25,0]})");
  EXPECT_EQ(gap[0]["gap"], 0.25);
  EXPECT_EQ(answer("mach_bands", R"({"image":[[0,0,1,2]]})"), nlohmann::json({{0, -1, 0, 0}}));
  EXPECT_EQ(good("shade barycentric --Ax 0 --Ay 0 --Bx 4 --By 0 --Cx 0 --Cy 4 --Px 1 --Py 1"),
            "alpha,beta,gamma,alpha_axes,beta_axes,gamma_axes,combinationx,combinationy,convex\n"
            "0.5,0.25,0.25,0.5,0.25,0.25,1,1,1\n");
  refuses("shade scanline -", 3,
          "standard input, object 1 (scanline): 'I' has 1 numbers; give 3, "
          "one for each vertex",
          input(R"({"size":[4,4],"polygon":[[0,0],[4,0],[0,4]],"I":[0]})"));
  refuses("shade mach_bands -", 3,
          "standard input, object 1 (mach_bands): 'image' has rows of "
          "several lengths",
          input(R"({"image":[[0],[1,2]]})"));
}

// A grazing eye, an eye opposite the light, nothing at all.
TEST_F(ShadeCommand, FiniteInputIsNeverNan) {
  const std::string rows =
      "Lx,Ly,Lz,Nx,Ny,Nz,Vx,Vy,Vz\n0,0,0,0,0,0,0,0,0\n0,0,1,0,0,1,0,0,-1\n"
      "1e308,-1e308,1e308,1e308,1e308,1e308,-1e308,1e308,1\n1e-320,0,0,1e-320,0,0,0,1e-320,0\n";
  for (const std::string model :
       {"vectors", "angles", "torrance_sparrow --m 0.3 --eta_i 1 --eta_t 1.5"}) {
    const std::string out = good("shade " + model + " -", input(rows));
    EXPECT_EQ(out.substr(out.find('\n')).find("nan"), std::string::npos) << out;
  }
}

}  // namespace
}  // namespace tristim
