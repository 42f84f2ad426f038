# pugixml, as WAYMARK_PUGIXML: static where there is one, for the shared one brings the shared C++ library, which every
# start of waymark would load. The static one of Debian is position-independent.
find_package(pugixml 1.13 REQUIRED)
set(WAYMARK_PUGIXML pugixml::pugixml)
if(TARGET pugixml::static)
  set(WAYMARK_PUGIXML pugixml::static)
endif()
