# Hypothesis: agent alpha switches to the policy named "safe".
# Use with what_if_too_costly.rq.
PREFIX ex: <http://example.org/mission/>
DELETE { ?agent ex:usesPolicy ?now }
INSERT { ?agent ex:usesPolicy ?safe }
WHERE {
  ?agent ex:id "alpha" ; ex:usesPolicy ?now .
  ?safe a ex:Policy ; ex:name "safe" .
}
