#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 3 adc_bailout 0 ambient_light rgb 1 }
background { rgb 0 }
camera { perspective location <0,-180,90> direction <0,0.9405539,-0.339644464> right <1.15470054,-0,0> up <0,0.392187645,1.08605809> }
light_source { <120,-120,160> rgb 1 fade_distance 707.107 fade_power 2 }
light_source { <-150,-60,200> rgb 1 fade_distance 500 fade_power 2 }
light_source { <0,-60,180> rgb 1 spotlight point_at <0,10,10> radius 30 falloff 30 tightness 0 fade_distance 707.107 fade_power 2 }
#declare T0 = texture { pigment { rgb <1,0.25,0.2> } finish { ambient 0.1 diffuse 0.4 phong 0.25 phong_size 30 reflection { 0.25 } } }
#declare T1 = texture { pigment { rgb <0.2,0.9,0.3> } finish { ambient 0.1 diffuse 0.45 phong 0.25 phong_size 15 reflection { 0.2 } } }
#declare T2 = texture { pigment { rgb <0.3,0.4,1> } finish { ambient 0.1 diffuse 0.35 phong 0.25 phong_size 50 reflection { 0.3 } } }
#declare T3 = texture { pigment { rgb <1,0.8,0.2> } finish { ambient 0.2 diffuse 0.4 phong 0.2 phong_size 10 reflection { 0.2 } } }
#declare T4 = texture { pigment { rgb <0.8,0.3,0.9> } finish { ambient 0.15 diffuse 0.4 phong 0.2 phong_size 20 reflection { 0.25 } } }
#declare T5 = texture { pigment { rgb <0.2,0.8,0.9> } finish { ambient 0.15 diffuse 0.45 phong 0.2 phong_size 5 reflection { 0.2 } } }
#declare T6 = texture { pigment { rgb <0.9,0.6,0.4> } finish { ambient 0.15 diffuse 0.4 phong 0.15 phong_size 25 reflection { 0.3 } } }
plane { z, 0 texture { pigment { checker rgb 1, rgb 0 scale 30 translate z*15 } finish { ambient 0.2 diffuse 0.5 phong 0 reflection { 0.3 } } } }
sphere{<0,0,30>,30 texture{T0}}
sphere{<-65,-30,22>,22 texture{T1}}
sphere{<60,45,25>,25 texture{T2}}
mesh {
  triangle { <-50,45,1>,<-10,45,1>,<-30,65,56> }
  triangle { <-10,45,1>,<-10,85,1>,<-30,65,56> }
  triangle { <-10,85,1>,<-50,85,1>,<-30,65,56> }
  triangle { <-50,85,1>,<-50,45,1>,<-30,65,56> }
  triangle { <-50,45,1>,<-10,85,1>,<-10,45,1> }
  triangle { <-50,45,1>,<-50,85,1>,<-10,85,1> }
  texture { T3 } }
mesh {
  triangle { <25,-80,1>,<55,-80,1>,<40,-65,41> }
  triangle { <55,-80,1>,<55,-50,1>,<40,-65,41> }
  triangle { <55,-50,1>,<25,-50,1>,<40,-65,41> }
  triangle { <25,-50,1>,<25,-80,1>,<40,-65,41> }
  triangle { <25,-80,1>,<55,-50,1>,<55,-80,1> }
  triangle { <25,-80,1>,<25,-50,1>,<55,-50,1> }
  texture { T4 } }
box { <50,-30,1>, <85,5,36> texture { T5 } }
box { <-110,30,1>, <-70,70,41> texture { T6 } }
