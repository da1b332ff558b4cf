BEGIN {
  print "static const float twiddle[64][2] = {"
  for (k = 0; k < 64; k++) printf "  {%.9g, %.9g},\n", cos(k * 3.14159265358979 / 64), -sin(k * 3.14159265358979 / 64)
  print "};"
}
