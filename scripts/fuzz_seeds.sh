# Seed inputs of each fuzzer, one per file. To be sourced.
#     seeds_of_<fuzzer> FOLDER

seeds_of_turtle() {
  cp config/missions/*/mission.ttl src/kg_mission/ontology/*.ttl "$1"
  printf 'ex:a ex:b ( 1 2.5 3e0 true "x"@en [ ex:c "y"^^ex:d ] ) .' >"$1/lists"
  printf '@prefix a: <http://a/> . a:b a:c """long \\u00e9 "text" """ .' \
    >"$1/long"
}

seeds_of_wkt() {
  local number=0 wkt
  while IFS= read -r wkt; do
    printf '%s' "$wkt" >"$1/$((number++))"
  done <<'END'
POINT(-93.9 27.45)
POLYGON((-94 27, -93 27, -93 28, -94 28, -94 27), (-93.6 27.4, -93.4 27.4, -93.4 27.6, -93.6 27.4))
MULTIPOLYGON(((0 0, 1 0, 1 1, 0 0)), ((2 2, 3 2, 3 3, 2 2)))
LINESTRING(170 1, 179.9 -1.5e0)
GEOMETRYCOLLECTION(POINT(1 2), LINESTRING(0 0, 1 1))
<http://www.opengis.net/def/crs/OGC/1.3/CRS84> POINT(190 10)
POLYGON((0 0, 2 2, 2 0, 0 2, 0 0))
MULTIPOINT((1 1), (2 2))
POLYGON EMPTY
END
}

seeds_of_query() {
  local number=0 text
  find config -name '*.rq' -exec cp {} "$1" \;
  while IFS= read -r text; do
    printf '%s' "$text" >"$1/$((number++))"
  done <<'END'
SELECT ?a (COUNT(*) AS ?n) WHERE { ?a a ex:Agent ; ex:speed ?s . FILTER(?s > 0.5) } GROUP BY ?a HAVING (COUNT(*) > 0) ORDER BY DESC(?n) LIMIT 5
SELECT * { ?a ex:after+/ex:speed? ?b OPTIONAL { ?b ex:since ?t } MINUS { ?a ex:near (1) } }
SELECT ?z { ?z geo:asWKT ?w FILTER(geof:sfWithin("POINT(0.5 0.5)"^^geo:wktLiteral, ?w)) }
CONSTRUCT { ?a ex:is [ ex:of ?p ] } WHERE { GRAPH ?g { ?a ex:usesPolicy ?p } }
ASK { VALUES (?x ?y) { (1 UNDEF) ("a"@en ex:b) } BIND(REPLACE(STR(?y), "b+", "c", "i") AS ?z) }
DESCRIBE ex:alpha
SELECT (SUM(?v * 2 - 1.5) AS ?t) (GROUP_CONCAT(?i; separator=",") AS ?l) { { SELECT ?v ?i { ?a ex:speed ?v ; ex:id ?i } } UNION { ?a !(ex:p|^ex:q) ?v } }
DELETE { ?a ex:speed ?s } INSERT { ?a ex:speed 2 } WHERE { ?a ex:speed ?s } ; CLEAR GRAPH graph:facts
INSERT DATA { ex:x ex:y "z"^^xsd:date ; ex:w true , -1.5e3 . GRAPH ex:g { ex:a ex:b ex:c } }
END
}

seeds_of_policy_json() {
  printf '{"corridor": 0.3}' >"$1/0"
  printf '{"ex:sanctuary": 1e-1, "corridor": -0.0}' >"$1/1"
  printf '{"a": [1, {"b": null}], "\\u00e9": true}' >"$1/2"
}
