// What the translator makes of single lines.
#include <gtest/gtest.h>

#include "compile/align_data.h"
#include "compile/command_line.h"
#include "compile/translate.h"

namespace spu_emu::compile {
namespace {

/// Of a source that has read the SDK's names.
std::string translated(const std::string& source, Language language = Language::cpp) {
  const std::string names = "# 1 \"vec_types.h\" 1 3\ntypedef int vec_uchar16;\n# 1 \"a.cpp\"\n";
  const std::string result = translate(names + source, language);
  EXPECT_EQ(result.substr(0, names.size()), names);
  return result.substr(names.size());
}

TEST(Translate, vector_before_a_built_in_type_names_the_type) {
  EXPECT_EQ(translated("vector unsigned int a;"), " vec_uint4 a;");
  EXPECT_EQ(translated("f(vector const signed char *p)"), "f( const vec_char16 *p)");
  EXPECT_EQ(translated("__vector bool short m;"), " vec_ushort8 m;");
  EXPECT_EQ(translated("vector unsigned long long l;"), " vec_ullong2 l;");
}

TEST(Translate, vector_is_a_name_elsewhere) {
  for (const char* line :
       {"std::vector<int> v;", "float vector;", "x.vector[2] = vector;", "vector<float> f(vector);",
        "\"vector unsigned int\"", "R\"x(vector float)\" )x\"", "f('\"', vector)"}) {
    EXPECT_EQ(translated(line), line);
  }
}

TEST(Translate, a_source_without_the_sdk_has_the_attribute) {
  EXPECT_EQ(translate("__vector float f;", Language::c), " float __attribute__((__vector_size__(16))) f;");
}

/// What the attribute is put before, which stands for it.
std::string with_marks(std::string source) {
  const std::string attribute = "__attribute__((aligned(16))) ";
  source = translated(source);
  for (std::size_t at = source.find(attribute); at != std::string::npos; at = source.find(attribute))
    source.replace(at, attribute.size(), "@");
  return source;
}

TEST(Translate, variables_of_functions_lie_at_multiples_of_16) {
  EXPECT_EQ(with_marks("int f(int a) { unsigned int b = a; char c, d[3]; float *e; return b; }"),
            "int f(int a) { @unsigned int b = a; @char c, d[3]; @float *e; return b; }");
  EXPECT_EQ(
      with_marks("void f() { const volatile long long a = 1; uint32_t b; struct block c = {1}; T d[4]; }"),
      "void f() { @const volatile long long a = 1; @uint32_t b; @struct block c = {1}; @T d[4]; }");
  EXPECT_EQ(with_marks("f(a) int a; { int b; for (;;) { int c; } if (a) { int d; } else { int e; } }"),
            "f(a) int a; { @int b; for (;;) { @int c; } if (a) { @int d; } else { @int e; } }");
  EXPECT_EQ(with_marks("struct S { int a; int g() const { int b; return b; } }; auto h = [] { int c; };"),
            "struct S { int a; int g() const { @int b; return b; } }; auto h = [] { @int c; };");
  EXPECT_EQ(with_marks("void f() { switch (a) { case 1: { int b; } } x = ({ int c; c; }); }"),
            "void f() { switch (a) { case 1: { @int b; } } x = ({ @int c; c; }); }");
}

TEST(Translate, what_is_no_variable_of_a_function_stays_where_it_is) {
  for (const char* line :
       {"int a; struct S { int b; unsigned c : 3; }; enum E { d, e }; int f[] = {1, 2};",
        "void f() { return a; goto b; delete c; throw d; case E: break; else g = h; }",
        "void f() { static int a; extern int b; register int c; typedef int d; int e(int); }",
        "void f() { struct S { int a; } b; x = (struct S){int(a)}; y = sizeof(int); }",
        "void f() { g(int(a)); a = b; a(b); a * b; std::vector<int> c; for (int d = 0; d < 1; ++d) h(d); }",
        "namespace n { int a; } extern \"C\" { int b; }"}) {
    EXPECT_EQ(with_marks(line), line);
  }
}

TEST(Translate, casts_to_vectors_are_calls_that_end_with_their_operand) {
  EXPECT_EQ(translated("x = (vec_uchar16)a + b;"), "x = spu_emu::cast< vec_uchar16>(a) + b;");
  EXPECT_EQ(translated("x = (vec_uchar16)p->q[i].f(1)++ * 2;"),
            "x = spu_emu::cast< vec_uchar16>(p->q[i].f(1)++) * 2;");
  EXPECT_EQ(translated("x = (vec_uint4)-~*p;"), "x = spu_emu::cast< vec_uint4>(-~*p);");
  EXPECT_EQ(translated("x = (vec_uint4)(qword)(vec_float4){1, 2};"),
            "x = spu_emu::cast< vec_uint4>(spu_emu::cast< qword>((vec_float4){1, 2}));");
  EXPECT_EQ(translated("g((vector signed short)f<3>(a), b);"), "g(spu_emu::cast< vec_short8>(f<3>(a)), b);");
  EXPECT_EQ(translated("return (vec_float4)a::b;"), "return spu_emu::cast< vec_float4>(a::b);");
  EXPECT_EQ(translated("a = reinterpret_cast<vec_int4>(b)[0];"), "a = spu_emu::cast< vec_int4>((b))[0];");
}

TEST(Translate, casts_to_parameters_of_templates_are_those_to_what_they_stand_for) {
  EXPECT_EQ(
      translated("template <class V, int N> V f(int x) { return (V)x + N; } int V; int y = (V)-x;"),
      "template <class V, int N> V f(int x) { return spu_emu::cast< V>(x) + N; } int V; int y = (V)-x;");
  EXPECT_EQ(
      translated(
          "template <typename T = vec_uint4> struct A { vec_uchar16 g(T t) { return static_cast<T>(t); } };"),
      "template <typename T = vec_uint4> struct A { vec_uchar16 g(T t) { return spu_emu::cast< T>((t)); } "
      "};");
  EXPECT_EQ(
      translated("template <class T> void f(T t) { x = (typename T::wide)t; p = (T *)q; T (*h)(T); }"),
      "template <class T> void f(T t) { x = spu_emu::cast< typename T::wide>(t); p = (T *)q; T (*h)(T); }");
}

TEST(Translate, casts_to_the_type_of_an_operand_are_those_to_what_the_compiler_finds) {
  EXPECT_EQ(translated("x = (decltype(a))b + (__typeof__(f(a, b)))-c;"),
            "x = spu_emu::cast< decltype(a)>(b) + spu_emu::cast< __typeof__(f(a, b))>(-c);");
  EXPECT_EQ(translated("x = static_cast<decltype(a)>(b); decltype(a) c; n = sizeof(decltype(a));"),
            "x = spu_emu::cast< decltype(a)>((b)); decltype(a) c; n = sizeof(decltype(a));");
  EXPECT_EQ(translated("x = (typeof(a))b;", Language::c), "x = spu_emu_cast_as(typeof(a), b);");
}

TEST(Translate, casts_in_the_style_of_a_function_are_calls_too) {
  EXPECT_EQ(translated("x = vec_uchar16(words) + g(vec_ushort8((vec_int4)y));"),
            "x = spu_emu::cast< vec_uchar16>(words) + g(spu_emu::cast< vec_ushort8>(spu_emu::cast< "
            "vec_int4>(y)));");
  for (const char* line :
       {"std::function<vec_uint4(vec_uchar16)> f;", "vec_uint4 (x);", "g(vec_uint4(*)(int));",
        "x = vec_uint4();", "auto f(int) -> vec_uint4;", "x = new vec_uint4(y);"}) {
    EXPECT_EQ(translated(line), line);
  }
}

TEST(Translate, typedefs_of_vectors_are_followed) {
  EXPECT_EQ(translated("typedef vec_uint4 A, B; x = (B)y;"),
            "typedef vec_uint4 A, B; x = spu_emu::cast< vec_uint4>(y);");
  EXPECT_EQ(translated("using C = const vec_bint4; x = (C)y;"),
            "using C = const vec_bint4; x = spu_emu::cast< vec_uint4>(y);");
}

TEST(Translate, what_only_looks_like_a_cast_stays) {
  for (const char* line :
       {"sizeof(vec_uint4) * n;", "vec_uint4 f(vec_uint4) const;", "void g(vec_uint4);",
        "x = (vec_uint4){1, 2, 3, 4};", "vec_uint4 *p = (vec_uint4 *)q;", "using F = void(vec_uint4);",
        "int f(vec_uint4) __attribute__((pure));", "[](vec_uint4) { return 1; };", "h = (int)x;"}) {
    EXPECT_EQ(translated(line), line);
  }
}

TEST(Translate, in_c_arguments_with_braces_are_one_for_a_macro) {
  EXPECT_EQ(translated("x = spu_add(a, (vec_int4){1, 2, 3, 4});", Language::c),
            "x = spu_add(a, ((vec_int4){1, 2, 3, 4}));");
  EXPECT_EQ(translated("x = f((vec_uint4)(vec_int4){1, 2}, g(b, 2));", Language::c),
            "x = f((spu_emu_cast_vec_uint4((vec_int4){1, 2})), g(b, 2));");
}

TEST(Translate, main_gets_a_name_and_a_linkage_of_its_own) {
  EXPECT_EQ(translated("int main() { }"), "extern \"C\" int spu_emu_program_main() { return 0;}");
  EXPECT_EQ(translated("int a; main(x) int x; { }", Language::c),
            "int a; spu_emu_program_main(x) int x; { return 0;}");
  EXPECT_EQ(translated("int main(void); int x;", Language::c), "int spu_emu_program_main(void); int x;");
  EXPECT_EQ(translated("extern \"C\" { int main() { return main(1); } }"),
            "extern \"C\" { extern \"C\" int spu_emu_program_main() { return spu_emu_program_main(1); return "
            "0;} }");
  EXPECT_EQ(translated("int f() { return x.main() + main; }"), "int f() { return x.main() + main; }");
  EXPECT_NE(translated("void main(void) { }", Language::c).find("main_is_void = 1"), std::string::npos);
}

TEST(Translate, lines_keep_their_numbers) {
  EXPECT_EQ(translated("x = (\nvector\n float\n)\na;"), "x = spu_emu::cast< vec_float4>(\n\n\n\na);");
}

TEST(AlignData, every_object_lies_at_a_multiple_of_16) {
  EXPECT_EQ(align_data("\t.type\tx, @object\nx:\n\t.long 3\n"),
            "\t.type\tx, @object\n\t.balign 16\nx:\n\t.long 3\n");
  EXPECT_EQ(align_data("\t.type\tf, @function\nf:\n.LC0:\n"), "\t.type\tf, @function\nf:\n.LC0:\n");
  EXPECT_EQ(align_data("\t.comm\tx,4,4\n"), "\t.comm\tx,4,16\n");
  EXPECT_EQ(align_data("\t.comm\tx,4,128\n"), "\t.comm\tx,4,128\n");
}

std::string joined(const Words& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

TEST(CompilerCommand, is_taken_apart_into_its_stages) {
  const auto line = CommandLine::of(
      {"g++", "-DA=1", "-I", "x", "-O2", "-std=gnu++17", "-MD", "-MF", "o.d", "-o", "o", "-c", "a.cpp"});
  ASSERT_TRUE(line.has_value());
  EXPECT_EQ(joined(line->preprocess("t")),
            "g++ -DA=1 -I x -O2 -std=gnu++17 -MD -MF o.d -DSPU_EMU_TRANSLATED -x c++ -E -o t a.cpp");
  EXPECT_EQ(joined(line->to_assembly("t", "s", false)), "g++ -O2 -std=gnu++17 -x c++-cpp-output -S -o s t");
  EXPECT_EQ(joined(line->assemble("s")), "g++ -x assembler -c -o o s");
}

TEST(CompilerCommand, compiles_c_as_c) {
  const auto line =
      CommandLine::of({"g++", "-std=gnu++17", "-fno-rtti", "-Ix", "-x", "c++", "-o", "o", "-c", "a.c"});
  ASSERT_TRUE(line.has_value());
  EXPECT_EQ(line->language(), Language::c);
  EXPECT_EQ(joined(line->to_assembly("t", "s", true)),
            "g++ -Ix -std=gnu11 -fcommon -fgnu89-inline -DSPU_EMU_TRANSLATED -imacros "
            "spu_emu/c/intrinsic_macros.h -x c -S "
            "-o s t");
  EXPECT_EQ(CommandLine::of({"g++", "--version"}), std::nullopt);
}

}  // namespace
}  // namespace spu_emu::compile
